// LessonEvaluator: the blocks of one lesson, one after the other.
//
// Each kind of block is found out about in a file of its own; here its result is put under its
// block, and the progress is told. Examples and their outputs have a crew of their own.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "evaluate/evaluate.h"
#include "evaluate/workshop.h"

namespace mjcourse {

// What one lesson's formulas, labs, figures, questions and inline values come to.
class LessonEvaluator {
 public:
  LessonEvaluator(const Lesson& lesson, Workshop& workshop, Progress& progress,
                  LessonResults& results, Diagnostics& diagnostics)
      : lesson_(lesson),
        workshop_(workshop),
        progress_(progress),
        results_(results),
        diagnostics_(diagnostics) {}

  // First what needs no example, then what may quote one.
  void run_beside_examples() { run(false); }
  void run_after_examples() { run(true); }

 private:
  void run(bool quoting);
  void evaluate_block(std::size_t index, const InlineValue& value);
  void evaluate_block(std::size_t index, const Math& math);
  void evaluate_block(std::size_t index, const Lab& lab);
  void evaluate_block(std::size_t index, const Figure& figure);
  void evaluate_block(std::size_t index, const Chart& chart);
  void evaluate_block(std::size_t index, const Quiz& quiz);
  void evaluate_block(std::size_t, const Snippet& snippet);
  void evaluate_block(std::size_t index, const ModelExcerpt& excerpt);
  void evaluate_block(std::size_t index, const InlineModel& model);
  void evaluate_block(std::size_t index, const Image& image);
  // Nothing to find out here: examples and their outputs have a crew of their own.
  template <typename Other>
  void evaluate_block(std::size_t, const Other&) {}

  // What came out well.
  template <typename Found>
  void keep(std::size_t index, std::optional<Found> found) {
    if (found) results_.of_block[index] = *std::move(found);
  }

  const Lesson& lesson_;
  Workshop& workshop_;
  Progress& progress_;
  LessonResults& results_;
  Diagnostics& diagnostics_;
};

}  // namespace mjcourse
