// Runs of an exercise's program with each of several texts in its region, as `grade` runs a
// hand-in: judged from outside (judge.h). The first is the solution.
//
// They are compiled once where they can be joined (joined_programs.h), and one by one where they
// cannot. A page runs the same texts with checks that judge for themselves.
// Tested by tests/courses/exercise.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/programs/example.h"
#include "evaluate/programs/hand_in_text.h"
#include "evaluate/programs/judge.h"
#include "evaluate/programs/judged_text.h"

namespace mjcourse {

struct JudgedRun {
  ExampleResult result;  // its checks are those that were made
  std::vector<JudgedCheck> verdict;
};

// A program with what was handed in, as it is judged. All must outlive it.
struct HandedInProgram {
  const Example& program;
  const std::string& text;  // all of it, with the code in marks (judged_text.h)
  std::string quoted;       // by messages: the same as its reader has it
  const Answers& answers;
  const HandInRules& rules;
  const JudgeKey& key;
};

// Nothing (reported) where its run went wrong, was forged, or is not to be: of what the
// preprocessor has made of the code, there may be a word that no hand-in has.
std::optional<JudgedRun> run_handed_in(const HandedInProgram& handed_in, const Lesson& lesson,
                                       WorkerContext& worker_context, Diagnostics& diagnostics);

// What the preprocessor makes of the code that is in marks in `text`. Nothing where it is not
// found.
std::optional<std::string> expanded_code(const Example& program, const std::string& text,
                                         const JudgeKey& key, const Lesson& lesson,
                                         WorkerContext& worker_context);

class VersionRuns {
 public:
  // `versions` are whole texts of `program`. All but these outlive it.
  VersionRuns(Example program, std::vector<std::string> versions, const Lesson& lesson,
              WorkerContext& worker_context, JudgeKey key = {});

  // Of the solution's run, which knows what it expects; with another `seed` than the key's, where
  // that is none of "". Nothing (reported) where that fails.
  std::optional<Answers> answers(Diagnostics& diagnostics, const std::string& seed = "");
  // The version, as run_handed_in().
  std::optional<JudgedRun> run(std::size_t index, const Answers& answers, Diagnostics& diagnostics);
  // Is it likely that nothing has to be compiled?
  bool is_known();
  // What another version than the solution is in the page, after run(), which gave `native`.
  std::optional<PageRun> run_in_page(std::size_t index, const ExampleResult& native);

 private:
  std::optional<NativeRun> run_joined(std::size_t place, const RunAs& as);
  Example at(std::size_t place) const;

  Example program_;
  std::vector<std::string> versions_;
  const Lesson& lesson_;
  WorkerContext& worker_context_;
  JudgeKey key_;
  std::optional<LocatedText> text_;      // of all places as one program
  std::optional<NativeProgram> joined_;  // nothing where that does not work, for whatever reason
};

}  // namespace mjcourse
