// FormerResults: what was known of a block before its lesson was edited, to be shown until it is
// known anew.
// Tested by tests/generator/session/live_session_test.cpp.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "session/snapshot.h"

namespace mjcourse {

class FormerResults {
 public:
  // `former` may be null: then there are none.
  explicit FormerResults(SnapshotPtr former);

  // Of the block that `block` of `lesson` was, as far as can be told: a program by its file, a
  // formula by its text, what is numbered by its number.
  std::optional<Result> find(const Lesson& lesson, std::size_t block) const;

 private:
  SnapshotPtr former_;
  std::map<std::pair<std::string, std::string>, const Result*> results_;  // by file and block
};

// All that was known, where `course` has the same lessons with the same blocks and some of their
// text is another; else null. Open are programs whose own text is.
std::shared_ptr<const Evaluation> former_evaluation(const Snapshot& former, const Course& course);

}  // namespace mjcourse
