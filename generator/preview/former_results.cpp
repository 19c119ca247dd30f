#include "preview/former_results.h"

#include <variant>

namespace mjcourse {
namespace {

struct NameOf {
  const Lesson& lesson;
  std::size_t index;

  std::string operator()(const Math& math) const { return math.tex.text; }
  std::string operator()(const InlineValue& value) const {
    return value.source.text + ":" + value.expression.text;
  }
  std::string operator()(const Example& example) const {
    return example.file.text + (example.region ? "#" + example.region->text : "");
  }
  std::string operator()(const Quiz& quiz) const { return quiz.id; }
  template <typename Other>
  std::string operator()(const Other&) const {
    return std::to_string(block_number(lesson, index));
  }
};

std::string name_of(const Lesson& lesson, std::size_t index) {
  const Block& block = lesson.blocks[index];
  return std::to_string(block.index()) + " " + std::visit(NameOf{lesson, index}, block);
}

// Writing a block goes through its parts and those of its result together.
bool fits(const Lab& lab, const LabResult& result) {
  if (lab.readouts.size() != result.readouts.size() || lab.plots.size() != result.traces.size() ||
      lab.controls.size() != result.keyframes.size()) {
    return false;
  }
  for (std::size_t i = 0; i < lab.plots.size(); ++i) {
    if (lab.plots[i].traces.size() != result.traces[i].size()) return false;
  }
  return true;
}

bool fits(const Block& block, const Result& result) {
  if (const auto* quiz = std::get_if<Quiz>(&block)) {
    return std::get<QuizResult>(result).questions.size() == quiz->questions.size();
  }
  const auto* lab = std::get_if<Lab>(&block);
  return lab == nullptr || fits(*lab, std::get<LabResult>(result));
}

}  // namespace

FormerResults::FormerResults(SnapshotPtr former) : former_(std::move(former)) {
  if (!former_) return;
  for (const Lesson* page : former_->course.pages()) {
    const LessonResults& results = former_->evaluation.results_of(former_->course, *page);
    for (const auto& [index, result] : results.of_block) {
      results_.try_emplace({page->source->path(), name_of(*page, index)}, &result);
    }
  }
}

std::optional<Result> FormerResults::find(const Lesson& lesson, std::size_t block) const {
  const auto found = results_.find({lesson.source->path(), name_of(lesson, block)});
  if (found == results_.end() || !fits(lesson.blocks[block], *found->second)) return std::nullopt;
  Result result = *found->second;
  // What it printed is former; what it is, is not.
  const auto* example = std::get_if<Example>(&lesson.blocks[block]);
  if (example != nullptr && !example->code.text.empty()) {
    std::get<ExampleResult>(result).code = example->code.text;
  }
  return result;
}

}  // namespace mjcourse
