// The text of a program as it is compiled to be judged from outside (judge.h).
// Tested by tests/generator/evaluate/programs/judged_text_test.cpp.
#pragma once

#include <cstdint>
#include <string>

namespace mjcourse {

// What one run of `check`, `try` or `grade` judges with. A hand-in must not know the first two.
struct JudgeKey {
  std::string name = "mjcourse_judge";  // of a namespace
  std::uint64_t mark = 0;
  std::string seed = {};  // what the helper header's seed() gives; "" for its own
  bool is_kept = true;    // may what comes of it be found another time?

  // That nobody knows before.
  static JudgeKey random();
};

// What stands behind a program's includes.
std::string reporting_checks(const JudgeKey& key);

// Directives in front of a program, by which its checks tell all that they are given; or what was
// found alone, so that the rest is not even compiled.
std::string tell_answers(const JudgeKey& key);
std::string tell_findings(const JudgeKey& key);

}  // namespace mjcourse
