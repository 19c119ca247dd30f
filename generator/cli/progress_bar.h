// A bar on the terminal for work that takes longer than half a second; silent elsewhere.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "evaluate/progress.h"

namespace mjcourse {

class ProgressBar : public Progress {
 public:
  ProgressBar();
  // Wipes the bar.
  ~ProgressBar() override;

  void plan(std::size_t tasks) override;
  void begin(const std::string& what) override;
  void end(const std::string& what) override;

 private:
  void draw();

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::size_t tasks_ = 0, finished_ = 0;
  std::vector<std::string> running_;  // the longest first
  std::jthread painter_;              // last: it uses the rest, and must end first
};

}  // namespace mjcourse
