#include "physics/mesa.h"

#include <cstdlib>
#include <system_error>

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCache = "MESA_SHADER_CACHE_DIR";
constexpr const char* kFolder = "mesa_shader_cache";  // which Mesa makes in it
constexpr const char* kThreads = "LP_NUM_THREADS";    // besides the one that draws

}  // namespace

void set_up_mesa(const std::optional<fs::path>& cache) {
  setenv(kThreads, "0", 0);
  if (!cache) return;
  setenv(kCache, cache->c_str(), 0);
  setenv("MESA_SHADER_CACHE_MAX_SIZE", "64M", 0);
}

LentShaders lend_shaders_to(const fs::path& folder) {
  LentShaders lent{{},
                   folder / kFolder,
                   {std::string(kCache) + "=" + folder.string(), std::string(kThreads) + "=0"}};
  fs::create_directories(lent.own);
  const char* kept = std::getenv(kCache);
  std::error_code none;
  if (kept == nullptr || !fs::is_directory(fs::path(kept) / kFolder, none)) return lent;
  lent.ours = fs::absolute(fs::path(kept) / kFolder);
  // Folders by the first two digits of a shader's hash; the index beside them is each user's own.
  for (const fs::directory_entry& entry : fs::directory_iterator(lent.ours, none)) {
    if (!entry.is_directory(none)) continue;
    fs::create_directory_symlink(entry.path(), lent.own / entry.path().filename(), none);
  }
  return lent;
}

}  // namespace mjcourse
