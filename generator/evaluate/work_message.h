// What a generator and its worker say to each other (worker.h, work_loop.h): a question names a
// task, and the answer has all that came of it.
//
// A worker has had to do with what strangers wrote, so an answer is looked at like a stranger's. It
// must be of the task that was asked for, name files of the course alone, and change nothing but
// what such a task may.
// Tested by tests/generator/evaluate/worker_test.cpp.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "evaluate/task.h"

namespace mjcourse {

struct WorkQuestion {
  std::vector<std::string> models;  // the course's
  std::string page, text;  // the file with the task's lesson, or the glossary, and its bytes
  std::size_t block = 0;   // of the task, as plan_tasks() has it of the page alone
  std::string what;
  // What programs told; null for one that failed. Once for all that a worker is asked.
  std::optional<std::map<std::string, std::optional<Records>>> reports = {};
};

struct WorkAnswer {
  bool whole = false;  // as Task::work() gives it
  Finding finding;
  std::set<std::string> looked_at;  // as Trace has it
  bool traced = false;
  std::string failure;  // what was thrown instead; "" for nothing
};

std::string encode(const WorkQuestion& question);
std::string encode(const WorkAnswer& answer);
// Nothing where it is none.
std::optional<WorkQuestion> decode_question(std::string_view bytes);
// `root` is the course's folder.
std::optional<WorkAnswer> decode_answer(std::string_view bytes, const Task& task,
                                        const std::filesystem::path& root);

}  // namespace mjcourse
