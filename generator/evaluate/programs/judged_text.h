// The text of a program as it is compiled to be judged from outside (judge.h).
// Tested by tests/generator/evaluate/programs/judged_text_test.cpp.
#pragma once

#include <optional>
#include <string>

#include "base/sip_hash.h"

namespace mjcourse {

// What one run of `check`, `try` or `grade` judges with. A hand-in must not know the first two.
struct JudgeKey {
  std::string name = "mjcourse_judge";  // of a namespace
  SipKey mark = {};
  std::string seed = {};  // what the helper header's seed() gives; "" for its own
  bool is_kept = true;    // may what comes of it be found another time?

  // That nobody knows before.
  static JudgeKey random();
};

// Is it a whole number from 1 to 999999999?
bool is_seed(const std::string& text);

// What stands behind a program's includes; and what its exit code goes through at its end.
std::string reporting_checks(const JudgeKey& key);
std::string end_of_checks(const JudgeKey& key);

// `code`, which was handed in, so that it can be found again in what the preprocessor makes of its
// program; its lines are counted from `line` on.
std::string marked_code(const JudgeKey& key, const std::string& code, int line,
                        const std::string& path);
// What became of it; nothing where it is not there.
std::optional<std::string> find_marked_code(const JudgeKey& key, const std::string& preprocessed);

// Directives in front of a program, by which its checks tell all that they are given; or what was
// found alone, so that the rest is not even compiled.
std::string tell_answers(const JudgeKey& key);
std::string tell_findings(const JudgeKey& key);

}  // namespace mjcourse
