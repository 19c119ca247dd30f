#include "process/open_to_all.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstddef>
#include <string>
#include <system_error>

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLookedAt = 5000;

bool has_mode(const fs::path& path, mode_t file, mode_t folder) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return errno == ENOENT;
  const mode_t wanted = S_ISDIR(status.st_mode) ? folder : file;
  return (status.st_mode & wanted) == wanted;
}

}  // namespace

bool can_be_reached_by_all(const fs::path& path) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path, error);
  if (error) return false;
  for (fs::path above = real.parent_path();; above = above.parent_path()) {
    if (!has_mode(above, 0, S_IXOTH)) return false;
    if (above == above.root_path()) return true;
  }
}

bool can_be_read_by_all(const fs::path& path) {
  const auto readable = [](const fs::path& one) {
    return has_mode(one, S_IROTH, S_IROTH | S_IXOTH);
  };
  if (!can_be_reached_by_all(path) || !readable(path)) return false;
  std::error_code error;
  if (!fs::is_directory(path, error)) return true;
  std::size_t count = 0;
  for (fs::recursive_directory_iterator entry(path, error), end; !error && entry != end;
       entry.increment(error)) {
    if (++count > kMostLookedAt || !readable(entry->path())) return false;
    if (entry->is_symlink(error) && !can_be_reached_by_all(entry->path())) return false;
  }
  return !error;
}

}  // namespace mjcourse
