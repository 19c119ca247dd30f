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

bool has_same_text(const Lesson& a, const Lesson& b) {
  if (a.kept != b.kept || a.kept == Lesson::Kept::card) return a.kept == b.kept && a.hash == b.hash;
  return a.source->text() == b.source->text();
}

bool shows_same(const Block& block, const Result& result) {
  const auto* example = std::get_if<Example>(&block);
  return example == nullptr || example->code.text.empty() ||
         example->code.text == std::get<ExampleResult>(result).code;
}

// Whether `results`, which are the old lesson's, can be shown in the young one.
bool has_same_blocks(const Lesson& old, const Lesson& young, const LessonResults& results) {
  if (old.source->path() != young.source->path() || old.blocks.size() != young.blocks.size()) {
    return false;
  }
  for (std::size_t i = 0; i < old.blocks.size(); ++i) {
    if (name_of(old, i) != name_of(young, i)) return false;
    const auto result = results.of_block.find(i);
    if (result == results.of_block.end()) continue;
    const Block& block = young.blocks[i];
    if (!fits(block, result->second) || !shows_same(block, result->second)) return false;
  }
  return true;
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

std::optional<Evaluation> FormerResults::all(const Course& course) const {
  if (!former_ || former_->course.lessons.size() != course.lessons.size()) return std::nullopt;
  const std::vector<const Lesson*> old = former_->course.pages(), young = course.pages();
  if (old.size() != young.size()) return std::nullopt;
  bool edited = false;
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (has_same_text(*old[i], *young[i])) continue;
    const LessonResults& results = former_->evaluation.results_of(former_->course, *old[i]);
    if (!has_same_blocks(*old[i], *young[i], results)) return std::nullopt;
    edited = true;
  }
  return edited ? std::optional(former_->evaluation) : std::nullopt;
}

}  // namespace mjcourse
