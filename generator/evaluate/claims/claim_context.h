// ClaimContext: a lesson while its blocks become claims.
//
// Each kind of block has a function claim() that says what is stated and whether it holds, how that
// was found out, how far, and what its key covers. They are kept by what they are about:
// code_claims.h has programs and all that is shown of them, shown_claims.h what a reader looks at
// and answers, prose_claims.h what stands in the text.
// Tested by tests/generator/evaluate/claims/claims_test.cpp.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "evaluate/claims/claim_sources.h"
#include "evaluate/context/fence_extent.h"
#include "findings/evaluation.h"

namespace mjcourse {

// The results of the examples by their files.
using Programs = std::map<std::string, ExampleResult>;

// Where a region stands for its whole program, because nothing shows that: (lesson, block).
using Stand = std::pair<std::size_t, std::size_t>;

struct ClaimContext {
  Claim begin(Claim::Kind kind, std::size_t block, std::string what, Span extent) const;
  // `claim` is done: its key covers `parts` beside what every key does. A claim that would be
  // proved fails where there is nothing that was found, or where an error stands in it.
  void finish(Claim claim, bool found, const std::vector<std::string>& parts);

  std::string written(Span span) const;
  Span fence(Span opening) const { return fence_extent(*lesson.source, opening); }
  const Versions& versions() const { return evaluation.versions; }
  std::string programs_sources(const std::string& text) {
    return hash_of({sources.helper(), sources.models_named_in(text)});
  }

  const Lesson& lesson;
  std::size_t index;  // of the lesson
  const LessonResults& results;
  const Evaluation& evaluation;
  const Programs& programs;
  const std::set<Stand>& stands;
  ClaimSources& sources;
  Claims claims = {};
};

}  // namespace mjcourse
