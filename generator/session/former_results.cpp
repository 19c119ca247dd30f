#include "session/former_results.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "base/any_of.h"
#include "evaluate/result_fits.h"

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
  template <AnyOf<TermUse, Exercise, Unchecked, Snippet, Commands, ModelExcerpt, InlineModel,
                  Output, Image, Io, Callout, Lab, Figure, Plot, Demo, Shown>
                Other>
  std::string operator()(const Other&) const {
    return std::to_string(block_number(lesson, index));
  }
};

std::string name_of(const Lesson& lesson, std::size_t index) {
  const Block& block = lesson.blocks[index];
  return std::to_string(block.index()) + " " + std::visit(NameOf{lesson, index}, block);
}

bool has_same_text(const Lesson& a, const Lesson& b) {
  if (a.kept != b.kept || a.kept == Lesson::Kept::outline)
    return a.kept == b.kept && a.hash == b.hash;
  return a.source->text() == b.source->text();
}

// Whether `results`, which are the old lesson's, can be shown in the young one.
bool has_same_blocks(const Lesson& old, const Lesson& young, const LessonResults& results) {
  if (old.source->path() != young.source->path() || old.blocks.size() != young.blocks.size()) {
    return false;
  }
  for (std::size_t i = 0; i < old.blocks.size(); ++i) {
    if (name_of(old, i) != name_of(young, i)) return false;
    const auto result = results.of_block.find(i);
    if (result != results.of_block.end() && !fits(young.blocks[i], result->second)) return false;
  }
  return true;
}

bool is_other_program(const Block& block, const Result& result) {
  const auto* example = std::get_if<Example>(&block);
  return example != nullptr && !example->code.text.empty() &&
         example->code.text != std::get<ExampleResult>(result).code;
}

// What it printed is former; what it is, is not.
void renew(const Block& block, Result& result) {
  if (!is_other_program(block, result)) return;
  std::get<ExampleResult>(result).code = std::get<Example>(block).code.text;
}

bool has_other_programs(const Lesson& young, const LessonResults& results) {
  return std::ranges::any_of(results.of_block, [&](const auto& known) {
    return is_other_program(young.blocks[known.first], known.second);
  });
}

// The programs that are others now are open, and so are their outputs.
void renew(const Lesson& young, LessonResults& results) {
  for (auto& [index, result] : results.of_block) {
    if (!is_other_program(young.blocks[index], result)) continue;
    renew(young.blocks[index], result);
    results.open.insert(index);
  }
  for (std::size_t i = 0; i < young.blocks.size(); ++i) {
    const auto* output = std::get_if<Output>(&young.blocks[i]);
    if (output != nullptr && results.open.contains(output->example)) results.open.insert(i);
  }
}

}  // namespace

FormerResults::FormerResults(SnapshotPtr former) : former_(std::move(former)) {
  if (!former_) return;
  for (const Lesson* page : former_->course.pages()) {
    const LessonResults& results = former_->evaluation->results_of(*page);
    for (const auto& [index, result] : results.of_block) {
      results_.try_emplace({page->source->path(), name_of(*page, index)}, &result);
    }
  }
}

std::optional<Result> FormerResults::find(const Lesson& lesson, std::size_t block) const {
  const auto found = results_.find({lesson.source->path(), name_of(lesson, block)});
  if (found == results_.end() || !fits(lesson.blocks[block], *found->second)) return std::nullopt;
  Result result = *found->second;
  renew(lesson.blocks[block], result);
  return result;
}

std::shared_ptr<const Evaluation> former_evaluation(const Snapshot& former, const Course& course) {
  if (former.course.lessons.size() != course.lessons.size()) return nullptr;
  const std::vector<const Lesson*> old = former.course.pages(), young = course.pages();
  if (old.size() != young.size()) return nullptr;
  const Evaluation& known = *former.evaluation;
  std::shared_ptr<Evaluation> renewed;
  bool edited = false;
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (has_same_text(*old[i], *young[i])) continue;
    const LessonResults& results = known.results_of(*old[i]);
    if (!has_same_blocks(*old[i], *young[i], results)) return nullptr;
    edited = true;
    if (!has_other_programs(*young[i], results)) continue;
    if (!renewed) renewed = std::make_shared<Evaluation>(known);
    renew(*young[i], renewed->results_of(*young[i]));
    renewed->open = true;
  }
  if (renewed) return renewed;
  return edited ? former.evaluation : nullptr;
}

}  // namespace mjcourse
