// LastRun: the name of the result that each task of a course had when it was last evaluated.
// `explain` compares with it.
//
// It is a question about this folder, and not about what is in it: one entry of the store, read
// when it is first needed, and written at the end where anything changed.
// Tested by tests/store/dependencies.mjs.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>

#include "base/store.h"
#include "evaluate/task.h"

namespace mjcourse {

class LastRun {
 public:
  // `root` is the course's folder. The store must outlive this.
  LastRun(Store& store, const std::filesystem::path& root);
  ~LastRun();
  LastRun(const LastRun&) = delete;
  LastRun& operator=(const LastRun&) = delete;

  // Both from any thread. The name of the result in the store; empty where there was none.
  std::string find(const Task& task);
  void note(const Task& task, const std::string& result);

 private:
  void read();

  Store& store_;
  const std::string name_;
  std::mutex mutex_;
  bool was_read_ = false, changed_ = false;
  std::map<std::string, std::string> results_;  // by tasks
};

}  // namespace mjcourse
