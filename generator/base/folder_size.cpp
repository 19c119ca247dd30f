#include "base/folder_size.h"

#include <sys/stat.h>

#include <filesystem>
#include <system_error>

namespace mjcourse {
namespace {

void add_file(const char* path, FolderSize& size) {
  constexpr std::uint64_t block = 512;
  struct stat status {};
  if (lstat(path, &status) == 0) size.bytes += static_cast<std::uint64_t>(status.st_blocks) * block;
}

}  // namespace

void add_size(const std::string& path, std::uint64_t most, FolderSize& size) {
  namespace fs = std::filesystem;
  std::error_code error;
  add_file(path.c_str(), size);
  for (fs::recursive_directory_iterator entry(path, error), end; !error && entry != end;
       entry.increment(error)) {
    add_file(entry->path().c_str(), size);
    if (++size.entries > most) return;
  }
  if (error == std::errc::permission_denied) size.entries = most + 1;
}

}  // namespace mjcourse
