// Versions: what everything was found out with.
#pragma once

#include <string>

namespace mjcourse {

struct Versions {
  std::string mjcourse;   // "0.1.0"
  std::string mujoco;     // "2.2.2"
  std::string compiler;   // "clang 16.0.6"; empty where no program was to be compiled
  std::string katex;      // "0.19.1"
  std::string engine;     // the content hash of MuJoCo for the page; empty where it was not built
  std::string page = {};  // of all that runs programs in the page; empty where they were not
};

}  // namespace mjcourse
