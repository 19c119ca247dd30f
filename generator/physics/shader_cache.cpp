#include "physics/shader_cache.h"

#include <cstdlib>

namespace mjcourse {

void keep_shaders_in(const std::filesystem::path& folder) {
  setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), 0);
  setenv("MESA_SHADER_CACHE_MAX_SIZE", "64M", 0);
}

}  // namespace mjcourse
