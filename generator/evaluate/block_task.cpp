#include "evaluate/block_task.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "base/any_of.h"
#include "base/stopwatch.h"
#include "evaluate/answers/inline_value.h"
#include "evaluate/answers/question.h"
#include "evaluate/context/fence_extent.h"
#include "evaluate/context/recipe.h"
#include "evaluate/scenes/figure.h"
#include "evaluate/scenes/image.h"
#include "evaluate/scenes/lab.h"
#include "evaluate/scenes/lab_scripts.h"
#include "evaluate/scenes/model_listing.h"
#include "evaluate/scenes/plot.h"

namespace mjcourse {
namespace {

using Names = std::vector<std::string>;

// What a kind of block is called, depends on, costs, and how it is worked on. Of other blocks there
// is nothing to find out, or by other tasks.
struct Known {
  std::string kind = {};
  std::string what;
  Names quoted = {};     // examples
  double effort = 0.01;  // seconds, about
  // As the lesson has it, and what reading the rest of the lesson made of it.
  Names text = {};
  Names scripts = {};  // that work on it
  bool draws = false;
};

struct KnownOf {
  const Lesson& lesson;
  std::size_t index;

  std::string written(Span span) const {
    return std::string(lesson.source->text().substr(span.begin, span.end - span.begin));
  }
  std::string fence(Span opening) const { return written(fence_extent(*lesson.source, opening)); }

  Known operator()(const InlineValue& value) const {
    return {"value",
            "compute " + value.expression.text + " of " + value.source.text,
            {value.source.text},
            0.02,
            {value.source.text, value.expression.text, value.format.text},
            {"world"}};
  }
  Known operator()(const Lab& lab) const {
    const double runs = 1.0 + static_cast<double>(lab.controls.size());
    return {"lab",      "rehearse the lab \"" + lab.title + "\"", {},
            0.1 * runs, {fence(lab.span), lab.pin.text},          {"world", "guard"},
            true};
  }
  Known operator()(const Figure& figure) const {
    const double frames = figure.animation ? figure.animation->frames() : 1;
    return {"figure",
            "draw a figure of " + lesson.number,
            figure.from ? Names{figure.from->example.text} : Names{},
            0.1 + 0.03 * frames,
            {fence(figure.span), figure.pin.text},
            {"world"},
            true};
  }
  Known operator()(const Plot& plot) const {
    return {"plot", "draw the plot of " + plot.table.text,         {plot.example.text},
            0.1,    {fence(plot.span), block_name(lesson, index)}, {"plot"}};
  }
  Known operator()(const Quiz& quiz) const {
    Known known{"quiz", "prove the answers of " + quiz.id, {}, 0.2, {}, {"world", "guard"}};
    for (const Question& question : quiz.questions) {
      known.text.push_back(written(question.span));
      for (const Proof& proof : question.proofs) {
        if (!proof.example.text.empty()) known.quoted.push_back(proof.example.text);
      }
    }
    return known;
  }
  Known operator()(const ModelExcerpt& excerpt) const {
    return {"excerpt", "look for lines of " + excerpt.model.text, {}, 0.01, {fence(excerpt.span)}};
  }
  Known operator()(const InlineModel& model) const {
    return {"model", "compile a model of " + lesson.number, {}, 0.01, {fence(model.span)}};
  }
  Known operator()(const Image& image) const { return {"image", "look at " + image.file.text}; }
  // Nothing is worked out of these alone.
  template <AnyOf<Math, TermUse, Example, Exercise, Unchecked, Snippet, Commands, Output, Io,
                  Callout, Demo, Shown>
                Other>
  Known operator()(const Other&) const {
    return {};
  }
};

Known known_of(const Lesson& lesson, std::size_t index) {
  return std::visit(KnownOf{lesson, index}, lesson.blocks[index]);
}

struct BlockWorker {
  const Lesson& lesson;
  std::size_t index;
  WorkerContext& worker_context;
  Diagnostics& diagnostics;

  using Answer = std::optional<Result>;

  Answer operator()(const InlineValue& value) const {
    return evaluate_value(value, lesson, worker_context, diagnostics);
  }
  Answer operator()(const Lab& lab) const {
    return evaluate_lab(lab, lesson, worker_context, diagnostics);
  }
  Answer operator()(const Figure& figure) const {
    return evaluate_figure(figure, lesson, worker_context, diagnostics);
  }
  Answer operator()(const Plot& plot) const {
    return evaluate_plot(plot, index, lesson, worker_context, diagnostics);
  }
  Answer operator()(const Quiz& quiz) const {
    QuizResult result;
    for (const Question& question : quiz.questions) {
      const Stopwatch stopwatch;
      auto answer = evaluate_question(question, lesson, worker_context, diagnostics);
      QuestionResult& kept = result.questions.emplace_back(answer.value_or(QuestionResult{}));
      kept.failed = !answer;
      kept.seconds = stopwatch.seconds();
    }
    return result;
  }
  Answer operator()(const ModelExcerpt& excerpt) const {
    return evaluate_excerpt(excerpt, lesson, worker_context, diagnostics);
  }
  Answer operator()(const InlineModel& model) const {
    return evaluate_inline_model(model, lesson, worker_context, diagnostics);
  }
  Answer operator()(const Image& image) const {
    return evaluate_image(image, lesson, worker_context.root(), diagnostics);
  }
  template <AnyOf<Math, TermUse, Example, Exercise, Unchecked, Snippet, Commands, Output, Io,
                  Callout, Demo, Shown>
                Other>
  Answer operator()(const Other&) const {
    return std::nullopt;
  }
};

// A quiz has a result even where an answer could not be found.
bool is_whole(const Result& result) {
  const auto* quiz = std::get_if<QuizResult>(&result);
  return quiz == nullptr || std::none_of(quiz->questions.begin(), quiz->questions.end(),
                                         [](const QuestionResult& one) { return one.failed; });
}

}  // namespace

BlockTask::BlockTask(const Lesson& lesson, std::size_t page, std::size_t block)
    : Task(lesson, page, block, known_of(lesson, block).what), block_(lesson.blocks[block]) {}

bool BlockTask::takes(const Lesson& lesson, std::size_t block) {
  return !known_of(lesson, block).kind.empty();
}

std::string BlockTask::name() const {
  const std::string numbered = block_name(lesson(), block());
  return numbered.empty() ? what() : numbered;
}

std::vector<std::string> BlockTask::quoted() const {
  return known_of(lesson(), block()).quoted;
}

bool BlockTask::draws() const {
  return known_of(lesson(), block()).draws;
}

double BlockTask::effort() const {
  return known_of(lesson(), block()).effort;
}

Dependencies BlockTask::recipe(const RunContext& run_context) const {
  const Known known = known_of(lesson(), block());
  if (known.text.empty()) return {};
  Dependencies recipe = recipe_of(run_context, known.kind, known.text, known.scripts);
  return known.draws ? with_drawing(std::move(recipe)) : recipe;
}

// A picture's size is found out without MuJoCo and the script engine.
bool BlockTask::is_apart() const {
  return !std::holds_alternative<Image>(block_);
}

bool BlockTask::work_apart(WorkerContext& worker_context, Finding& finding) {
  return !is_apart() || find_out(worker_context, finding);
}

// What a worker found and a page will run or draw is looked at here, where no author's text works.
bool BlockTask::work(WorkerContext& worker_context, Finding& finding) {
  if (!is_apart()) return find_out(worker_context, finding);
  const auto found = finding.results.find(block());
  if (found == finding.results.end()) return true;
  if (auto* lab = std::get_if<LabResult>(&found->second)) {
    if (!guard_scripts(std::get<Lab>(block_), lesson(), worker_context, lab->scripts)) {
      throw std::runtime_error("the lab was rehearsed with a script that no page runs");
    }
  } else if (auto* plot = std::get_if<PlotResult>(&found->second)) {
    if (!are_plain(plot->drawings, block_name(lesson(), block()))) {
      finding.diagnostics.push_back(error_at(
          place(), "E-plot-spec", "the plot's drawing would have what no page shows",
          "look for an address or markup in a colour or a font, and for control characters in "
          "its texts"));
      finding.results.clear();
      return false;
    }
    plot->file = file_of_example(std::get<Plot>(block_).example.text, worker_context.course());
  }
  return true;
}

bool BlockTask::find_out(WorkerContext& worker_context, Finding& finding) const {
  const Stopwatch stopwatch;
  std::optional<Result> result =
      std::visit(BlockWorker{lesson(), block(), worker_context, finding.diagnostics}, block_);
  if (!result) return false;
  const bool whole = is_whole(*result);
  finding.results[block()] = *std::move(result);
  finding.seconds[block()] = stopwatch.seconds();
  return whole;
}

}  // namespace mjcourse
