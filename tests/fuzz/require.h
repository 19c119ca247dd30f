// What must hold of every input. Where it does not, the program dies, as fuzzers do.
#pragma once

#include <iostream>
#include <string>

namespace mjcourse {

inline void require(bool holds, const std::string& what) {
  if (holds) return;
  std::cerr << "does not hold: " << what << std::endl;
  __builtin_trap();
}

}  // namespace mjcourse
