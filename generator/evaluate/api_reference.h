// The names of MuJoCo's that the course uses: those that it links to, `[text](api:mj_step)`, held
// against the headers, and those in programs that were run and in scripts (evaluate/code_names.h).
#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "course/course.h"
#include "evaluate/result.h"
#include "physics/mujoco_api.h"
#include "report/diagnostic.h"

namespace mjcourse {

struct CodeUse {
  std::size_t page = 0, block = 0;  // Course::pages, and the block's index there
  Span place;                       // of the code, or of the fence that shows it
  std::set<int> lines;              // from 1, of a program as it is shown; none of other code
};

struct ApiEntry {
  std::string name;                     // "mj_step", "mjModel.nq"
  std::string kind;                     // in words: "function", "field of mjModel"
  std::string declaration;              // C, as the header has it
  std::string comment;                  // the header's; may be empty
  std::string header;                   // "mujoco.h"
  std::string section;                  // of the header; may be empty
  std::string url;                      // of MuJoCo's own documentation; may be empty
  std::vector<CodeUse> uses_in_code{};  // in the course's order
};

// Each name once, in the order of its letters; those that only drafts use are checked and left out.
// `results` are those of each page. `headers` is asked for MuJoCo's names only where there is a
// link or code; where they cannot be read, only a link is in error.
using MujocoHeaders = std::function<const tl::expected<MujocoApi, std::string>&()>;
using ResultsOf = std::function<const LessonResults&(const Lesson&)>;
std::vector<ApiEntry> evaluate_api(const Course& course, const ResultsOf& results,
                                   const MujocoHeaders& headers, Diagnostics& diagnostics);

}  // namespace mjcourse
