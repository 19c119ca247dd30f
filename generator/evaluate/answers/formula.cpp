#include "evaluate/answers/formula.h"

#include <algorithm>
#include <string>

namespace mjcourse {
namespace {

// KaTeX needs about 10 kB of memory for a byte, and looks at a limit of time now and then only.
constexpr std::size_t kMostTex = 10'000;  // bytes

}  // namespace

std::optional<FormulaResult> evaluate_formula(const Math& math, const Lesson& lesson,
                                              WorkerContext& worker_context,
                                              Diagnostics& diagnostics) {
  const std::string& tex = math.tex.text;
  if (tex.size() > kMostTex) {
    diagnostics.push_back(
        error_at(place_of(*lesson.source, math.tex.span(0, 1)), "E-math",
                 "a formula may have " + std::to_string(kMostTex) + " bytes, and this one has " +
                     std::to_string(tex.size()),
                 "say it in several; numbers by the hundred are a table or a plot"));
    return std::nullopt;
  }
  tl::expected<std::string, MathError> markup =
      worker_context.typesetter().typeset(tex, math.display);
  if (markup) return FormulaResult{*std::move(markup)};
  const MathError& error = markup.error();
  const std::size_t end = error.offset + std::max<std::size_t>(1, error.length);
  diagnostics.push_back(error_at(place_of(*lesson.source, math.tex.span(error.offset, end)),
                                 "E-math", error.message, error.cure));
  return std::nullopt;
}

}  // namespace mjcourse
