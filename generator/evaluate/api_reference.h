// The names of MuJoCo's that the course uses: those that it links to, `[text](api:mj_step)`, held
// against the headers, and those in programs that were run and in scripts (evaluate/code_names.h).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "course/course.h"
#include "findings/api_entry.h"
#include "findings/lesson_results.h"
#include "physics/mujoco_api.h"
#include "report/diagnostic.h"

namespace mjcourse {

// Each name once, in the order of its letters; those that only drafts use are checked and left out.
// `results` are those of each page. `headers` is asked for MuJoCo's names only where there is a
// link or code; where they cannot be read, only a link is in error. Several threads ask both.
using MujocoHeaders = std::function<const tl::expected<MujocoApi, std::string>&()>;
using ResultsOf = std::function<const LessonResults&(const Lesson&)>;
std::vector<ApiEntry> evaluate_api(const Course& course, const ResultsOf& results,
                                   const MujocoHeaders& headers, std::size_t threads,
                                   Diagnostics& diagnostics);

}  // namespace mjcourse
