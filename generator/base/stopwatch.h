// Stopwatch: how long something took, for reports; nothing that is built may depend on it.
#pragma once

#include <chrono>

namespace mjcourse {

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace mjcourse
