#include "base/folder_size.h"

#include <sys/stat.h>

#include <filesystem>

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
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator entry(path, options, error), end; !error && entry != end;
       entry.increment(error)) {
    add_file(entry->path().c_str(), size);
    if (++size.entries > most) return;
  }
}

}  // namespace mjcourse
