// What went wrong in the run of a lesson's code, in words for its author.
#pragma once

#include <optional>
#include <string>

#include "process/subprocess.h"
#include "report/diagnostic.h"

namespace mjcourse {

struct ExpectedRun {
  std::string what;  // as messages call it: "program"
  double seconds = 10;
  int exit_code = 0;
  Sandbox sandbox = {};  // that it ran in, whose limits are told
};

// Nothing when the run ended as it was to end; else a diagnostic that has no place yet.
std::optional<Diagnostic> judge_run(const Outcome& outcome, const ExpectedRun& expected);

}  // namespace mjcourse
