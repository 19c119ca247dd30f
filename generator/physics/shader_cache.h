// Where Mesa keeps the shaders that it compiled: with what else we cache, and not in a folder of
// its own. A first picture takes 0.3 s of CPU instead of 0.6 with them.
#pragma once

#include <filesystem>

namespace mjcourse {

// Before the first Renderer, and before there are threads: it sets Mesa's environment variables,
// where the user did not.
void keep_shaders_in(const std::filesystem::path& folder);

}  // namespace mjcourse
