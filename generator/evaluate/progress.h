// Progress: what is told of the work as it goes on.
#pragma once

#include <cstddef>
#include <string>

namespace mjcourse {

// Told of the work as it goes, from any thread.
class Progress {
 public:
  virtual ~Progress() = default;
  virtual void plan(std::size_t tasks) = 0;
  virtual void begin(const std::string& what) = 0;  // "compile and run l1_2_…"; not of what is kept
  virtual void end(const std::string& what) = 0;    // of every task
};

}  // namespace mjcourse
