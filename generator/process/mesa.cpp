#include "process/mesa.h"

#include <cstdlib>
#include <system_error>

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCache = "MESA_SHADER_CACHE_DIR";
constexpr const char* kFolder = "mesa_shader_cache";  // which Mesa makes in it
// From 24 on it makes that only where it is told to; else it is one file, which cannot be lent.
constexpr const char* kManyFiles = "MESA_DISK_CACHE_MULTI_FILE";
constexpr const char* kThreads = "LP_NUM_THREADS";  // besides the one that draws

}  // namespace

void set_up_mesa(const std::optional<fs::path>& cache) {
  setenv(kThreads, "0", 0);
  if (!cache) return;
  setenv(kCache, cache->c_str(), 0);
  setenv(kManyFiles, "1", 0);
  setenv("MESA_SHADER_CACHE_MAX_SIZE", "64M", 0);
}

LentShaders lend_shaders_to(const fs::path& folder) {
  LentShaders lent{{},
                   folder / kFolder,
                   {std::string(kCache) + "=" + folder.string(), std::string(kManyFiles) + "=1",
                    std::string(kThreads) + "=0"}};
  fs::create_directories(lent.own);
  const char* kept = std::getenv(kCache);
  std::error_code none;
  if (kept == nullptr || !fs::is_directory(fs::path(kept) / kFolder, none)) return lent;
  lent.ours = fs::absolute(fs::path(kept) / kFolder);
  // In folders by the first digits of their hashes; the index beside these is each user's own.
  for (const fs::directory_entry& folder_of : fs::directory_iterator(lent.ours, none)) {
    if (!folder_of.is_directory(none)) continue;
    const fs::path its = lent.own / folder_of.path().filename();
    fs::create_directory(its);
    fs::permissions(its, fs::perms::all);  // the program may run as somebody else
    for (const fs::directory_entry& shader : fs::directory_iterator(folder_of.path(), none)) {
      // One that is being written the program would write, too, and into ours.
      if (shader.path().extension() == ".tmp") continue;
      fs::create_symlink(shader.path(), its / shader.path().filename(), none);
    }
  }
  return lent;
}

}  // namespace mjcourse
