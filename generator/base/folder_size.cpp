#include "base/folder_size.h"

#include <sys/stat.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace mjcourse {
namespace {

// Deeper than any program builds: each level costs an open folder, and a longer name.
constexpr int kMostDepth = 100;

// False where nothing can be known of it, though it may be there.
bool add_file(const char* path, FolderSize& size) {
  constexpr std::uint64_t block = 512;
  struct stat status {};
  if (lstat(path, &status) != 0) return errno == ENOENT || errno == ENOTDIR;
  size.bytes += static_cast<std::uint64_t>(status.st_blocks) * block;
  return true;
}

// Removed meanwhile, or a file and no folder.
bool is_gone(const std::error_code& error) {
  return error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory;
}

}  // namespace

void add_size(const std::string& path, std::uint64_t most, FolderSize& size) {
  namespace fs = std::filesystem;
  std::error_code error;
  bool known = add_file(path.c_str(), size);
  for (fs::recursive_directory_iterator entry(path, error), end; known && !error && entry != end;
       entry.increment(error)) {
    known = add_file(entry->path().c_str(), size) && entry.depth() < kMostDepth;
    if (++size.entries > most) return;
  }
  if (!known || (error && !is_gone(error))) size.entries = most + 1;
}

}  // namespace mjcourse
