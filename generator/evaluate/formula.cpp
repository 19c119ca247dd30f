#include "evaluate/formula.h"

#include <algorithm>

namespace mjcourse {

std::optional<FormulaResult> evaluate_formula(const Math& math, const Lesson& lesson,
                                              Workshop& workshop, Diagnostics& diagnostics) {
  tl::expected<std::string, MathError> markup =
      workshop.typesetter().typeset(math.tex.text, math.display);
  if (markup) return FormulaResult{*std::move(markup)};
  const MathError& error = markup.error();
  const std::size_t end = error.offset + std::max<std::size_t>(1, error.length);
  diagnostics.push_back(error_at(place_of(*lesson.source, math.tex.span(error.offset, end)),
                                 "E-math", error.message, error.cure));
  return std::nullopt;
}

}  // namespace mjcourse
