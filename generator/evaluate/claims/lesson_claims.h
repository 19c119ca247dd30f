// LessonClaims: the blocks of one lesson as claims.
//
// Each kind of block has a function that says what is stated and whether it holds, how that was
// found out, how far, and what its key covers. They are kept by what they are about:
// code_claims.cpp has programs and all that is shown of them, shown_claims.cpp what a reader looks
// at and answers, prose_claims.cpp what stands in the text.
// Tested by tests/generator/evaluate/claims/claims_test.cpp.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "evaluate/claims/claim_sources.h"
#include "evaluate/claims/fence_extent.h"
#include "findings/evaluation.h"

namespace mjcourse {

// The results of the examples by their files.
using Programs = std::map<std::string, ExampleResult>;

// Where a region stands for its whole program, because nothing shows that: (lesson, block).
using Stand = std::pair<std::size_t, std::size_t>;

class LessonClaims {
 public:
  LessonClaims(const Lesson& lesson, std::size_t index, const LessonResults& results,
               const Evaluation& evaluation, const Programs& programs,
               const std::set<Stand>& stands, ClaimSources& sources)
      : lesson_(lesson),
        index_(index),
        results_(results),
        evaluation_(evaluation),
        programs_(programs),
        stands_(stands),
        sources_(sources) {}

  Claims run();

 private:
  void add(std::size_t i, const Example& example);
  void add_program(std::size_t i, const Example& example, const ExampleResult* result, Span extent);
  void add(std::size_t i, const Snippet& snippet);
  void add(std::size_t i, const Commands& commands);
  void add(std::size_t i, const Output& output);
  void add(std::size_t i, const ModelExcerpt& excerpt);
  void add(std::size_t i, const InlineModel& model);
  void add(std::size_t i, const InlineValue& value);
  void add(std::size_t i, const Math& math);
  void add(std::size_t i, const Lab& lab);
  void add(std::size_t i, const Figure& figure);
  void add(std::size_t i, const Plot& plot);
  void add(std::size_t i, const Image& image);
  void add(std::size_t i, const Quiz& quiz);
  void add(std::size_t i, const Callout& callout);
  void add(std::size_t i, const Unchecked& unchecked);
  // States nothing that could be untrue.
  void add(std::size_t, const Io&) {}
  void add(std::size_t, const TermUse&) {}
  void add(std::size_t, const Demo&) {}  // its blocks are the lesson's
  void add(std::size_t, const Shown&) {}

  Claim begin(Claim::Kind kind, std::size_t block, std::string what, Span extent) const;
  // `claim` is done: its key covers `parts` beside what every key does. A claim that would be
  // proved fails where there is nothing that was found, or where an error stands in it.
  void finish(Claim claim, bool found, const std::vector<std::string>& parts);
  bool has_error(Span extent) const;
  std::string written(Span span) const;
  Span fence(Span opening) const { return fence_extent(*lesson_.source, opening); }
  const Versions& versions() const { return evaluation_.versions; }
  std::string programs_sources(const std::string& text) {
    return hash_of({sources_.helper(), sources_.models_named_in(text)});
  }

  const Lesson& lesson_;
  std::size_t index_;
  const LessonResults& results_;
  const Evaluation& evaluation_;
  const Programs& programs_;
  const std::set<Stand>& stands_;
  ClaimSources& sources_;
  Claims claims_;
};

}  // namespace mjcourse
