#include "base/cache_folder.h"

#include <unistd.h>

#include <cstdlib>
#include <system_error>

namespace mjcourse {
namespace fs = std::filesystem;

std::optional<fs::path> user_cache_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  fs::path folder;
  // The convention's own words: what is not absolute is as good as not set.
  if (cache != nullptr && fs::path(cache).is_absolute()) {
    folder = fs::path(cache) / "mjcourse";
  } else if (home != nullptr && fs::path(home).is_absolute()) {
    folder = fs::path(home) / ".cache" / "mjcourse";
  } else {
    return std::nullopt;
  }
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure || access(folder.c_str(), W_OK) != 0) return std::nullopt;
  return folder;
}

}  // namespace mjcourse
