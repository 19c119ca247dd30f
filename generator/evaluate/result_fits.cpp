#include "evaluate/result_fits.h"

#include <variant>

namespace mjcourse {
namespace {

bool has_parts_of(const Lab& lab, const LabResult& result) {
  if (lab.readouts.size() != result.readouts.size() || lab.plots.size() != result.traces.size() ||
      lab.controls.size() != result.keyframes.size()) {
    return false;
  }
  for (std::size_t i = 0; i < lab.plots.size(); ++i) {
    if (lab.plots[i].traces.size() != result.traces[i].size()) return false;
  }
  return true;
}

struct Fits {
  const Result& result;

  template <typename Kind>
  bool is() const {
    return std::holds_alternative<Kind>(result);
  }
  bool operator()(const Math&) const { return is<FormulaResult>(); }
  bool operator()(const InlineValue&) const { return is<ValueResult>(); }
  bool operator()(const Example&) const { return is<ExampleResult>(); }
  bool operator()(const ModelExcerpt&) const { return is<ModelResult>(); }
  bool operator()(const InlineModel&) const { return is<ModelResult>(); }
  bool operator()(const Output&) const { return is<OutputResult>(); }
  bool operator()(const Image&) const { return is<ImageResult>(); }
  bool operator()(const Figure&) const { return is<FigureResult>(); }
  bool operator()(const Chart&) const { return is<ChartResult>(); }
  bool operator()(const Lab& lab) const {
    const auto* known = std::get_if<LabResult>(&result);
    return known != nullptr && has_parts_of(lab, *known);
  }
  bool operator()(const Quiz& quiz) const {
    const auto* known = std::get_if<QuizResult>(&result);
    return known != nullptr && known->questions.size() == quiz.questions.size();
  }
  // Snippets and commands are programs; of other kinds there is no result.
  template <typename Other>
  bool operator()(const Other&) const {
    return is<ExampleResult>();
  }
};

}  // namespace

bool fits(const Block& block, const Result& result) {
  return std::visit(Fits{result}, block);
}

}  // namespace mjcourse
