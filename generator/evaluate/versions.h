// Versions: what everything was found out with.
#pragma once

#include <string>

#include "base/files.h"

namespace mjcourse {

struct Versions {
  std::string mjcourse;  // "0.1.0"
  std::string mujoco;    // "2.2.2"
  std::string compiler;  // "clang 16.0.6"; empty where no program was to be compiled
  std::string katex;     // "0.19.1"
  std::string engine;    // the content hash of MuJoCo for the page; empty where it was not built
};

// All but the compiler's, which is asked for its own; `assets` holds what the site's build made.
Versions known_versions(const Files& assets);

}  // namespace mjcourse
