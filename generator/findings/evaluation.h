// Evaluation: what was found out about a course.
//
// Data alone: evaluate/ fills it, and whatever shows a course reads it, in pages, reports, the
// preview and the editor.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "course/course.h"
#include "findings/api_entry.h"
#include "findings/lesson_results.h"
#include "findings/model_page.h"
#include "findings/versions.h"
#include "report/diagnostic.h"

namespace mjcourse {

// When a task was worked on, in seconds since the first began; measured.
struct TaskTime {
  std::string what;
  std::size_t thread = 0;
  double begin = 0, seconds = 0;
  bool reused = false;
  double in_page = 0;  // of its seconds, those that the page's compiler and engine took
};

struct Evaluation {
  std::vector<LessonResults> lessons;  // one for each lesson of the course
  LessonResults glossary = {};         // of its page
  std::vector<ModelPage> models = {};  // that the course links to
  std::vector<ApiEntry> api = {};      // names of MuJoCo's that it uses
  std::string api_names = "[]";  // all there are, for a reader's editor (evaluate/api_names.h)
  Diagnostics diagnostics;
  Versions versions;
  std::string sandbox = {};              // how what was run was contained; empty where nothing was
  std::vector<TaskTime> times = {};      // of all tasks, as they began
  bool open = false;                     // something is still to be worked out
  std::size_t open_in_page = 0;          // tasks of programs in the page among that
  std::size_t all_tasks = 0, tasks = 0;  // of all shards, and of this one
  std::string division = {};             // into shards (evaluate/shard.h)

  // Those of a page of the course (Course::pages).
  const LessonResults& results_of(const Lesson& page) const {
    return page.index ? lessons.at(*page.index) : glossary;
  }
  LessonResults& results_of(const Lesson& page) {
    return page.index ? lessons.at(*page.index) : glossary;
  }
};

}  // namespace mjcourse
