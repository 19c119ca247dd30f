// Enter evaluating here: from a course that was read to what is true of it.
//
// The examples, which cost most, run on threads of their own while formulas, labs and questions
// are worked off on the calling thread. What always holds: the results and the diagnostics do not
// depend on the number of threads.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/files.h"
#include "course/course.h"
#include "evaluate/api_reference.h"
#include "evaluate/model_page.h"
#include "evaluate/result.h"
#include "evaluate/versions.h"
#include "report/diagnostic.h"

namespace mjcourse {

// Told of the work as it goes, from any thread, one call at a time.
class Progress {
 public:
  virtual ~Progress() = default;
  virtual void plan(int tasks) = 0;
  virtual void begin(const std::string& what) = 0;  // "compile and run l1_2_…"
  virtual void done() = 0;
};

struct Evaluation {
  std::vector<LessonResults> lessons;  // one for each lesson of the course
  LessonResults glossary = {};         // of its page
  std::vector<ModelPage> models = {};  // that the course links to
  std::vector<ApiEntry> api = {};      // names of MuJoCo's that it links to
  Diagnostics diagnostics;
  Versions versions;

  // Those of a page of `course` (Course::pages).
  const LessonResults& results_of(const Course& course, const Lesson& page) const;
};

// `root` is the course's folder, `assets` what the site's build made. The diagnostics begin with
// what reading the course `found` wrong.
Evaluation evaluate(const Course& course, const std::filesystem::path& root, const Files& assets,
                    Progress& progress, Diagnostics found = {});

}  // namespace mjcourse
