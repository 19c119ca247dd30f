#include "page/blocks/block_data.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <utility>

#include "findings/snippet_program.h"
#include "page/blocks/program_data.h"
#include "page/html/anchors.h"
#include "page/html/site_paths.h"

namespace mjcourse {
namespace {

using nlohmann::json;

std::string capitalized(std::string word) {
  if (!word.empty()) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  return word;
}

// How the text that `program` printed, which may be called "this program", came about.
std::string output_label(const Example& example, const std::string& program) {
  if (!example.compiles) return "Said by the compiler, which refuses " + program;
  std::string label = "Printed by " + program;
  for (std::size_t i = 0; i < example.arguments.size(); ++i) {
    label += (i == 0 ? " when run with " : " ") + example.arguments[i];
  }
  if (example.exit_code == 0) return label;
  return label + ", which exits with code " + std::to_string(example.exit_code);
}

// Of an output with more lines than `kMostOutputLines`, only the first are shown at once.
constexpr std::ptrdiff_t kMostOutputLines = 30, kFirstOutputLines = 20;

// What example.hbs calls an output.
json output_data(const std::string& text, bool proved, const std::string& label) {
  std::size_t shown = text.size();
  const std::ptrdiff_t lines = std::count(text.begin(), text.end(), '\n');
  if (lines > kMostOutputLines) {
    shown = 0;
    for (std::ptrdiff_t i = 0; i < kFirstOutputLines; ++i) shown = text.find('\n', shown) + 1;
  }
  return {{"text", text.substr(0, shown)},
          {"proved", proved},
          {"label", label},
          {"rest", text.substr(shown)},
          {"more", lines - kFirstOutputLines}};
}

json listing(const std::string& code, const std::string& language, const LessonContext& context) {
  const json highlighted =
      code.empty() ? json() : json(context.page.highlighter.highlight(code, language));
  return {{"id", nullptr},     {"program", nullptr},  {"file", nullptr},    {"download", nullptr},
          {"zip", nullptr},    {"code", highlighted}, {"unchecked", false}, {"because", ""},
          {"output", nullptr}, {"run", nullptr},      {"why_not", nullptr}, {"exercise", nullptr}};
}

// What a reader can do with the program beside reading it.
void offer_program(const Example& program, const ExampleResult* result,
                   const LessonContext& context, json& data) {
  data["program"] = program.file.text;
  if (const std::string zip = program_zip_path(program, result); !zip.empty()) {
    data["zip"] = context.from_root(zip);
  }
  data["run"] = run_data(program, result, context);
  data["why_not"] = why_not_data(result);
}

// Those of a program's stated outputs that do not stand somewhere else in the lesson.
std::vector<std::size_t> outputs_below(const std::vector<std::size_t>& outputs,
                                       const LessonContext& context) {
  std::vector<std::size_t> below;
  for (const std::size_t index : outputs) {
    if (!std::get<Output>(context.lesson.blocks[index]).apart) below.push_back(index);
  }
  return below;
}

bool are_proved(const std::vector<std::size_t>& outputs, const LessonContext& context) {
  return !outputs.empty() && std::all_of(outputs.begin(), outputs.end(), [&](std::size_t index) {
    return context.results.get<OutputResult>(index) != nullptr;
  });
}

}  // namespace

json data_of(const Example& example, std::size_t index, LessonContext& context) {
  const auto* result = context.results.get<ExampleResult>(index);
  json data = listing(result != nullptr ? result->code : example.code.text, "cpp", context);
  data["id"] = context.unique_id(example_anchor(example));
  data["file"] = example.file.text;
  data["download"] = context.from_root(example.file.text);
  offer_program(example, result, context, data);
  // Of a program's regions, those have its output that say so; and where it is stated somewhere
  // else alone, that is where a reader finds it.
  const std::vector<std::size_t> below = outputs_below(example.outputs, context);
  const bool elsewhere = below.empty() && (example.region || !example.outputs.empty());
  const bool printed = result != nullptr && !elsewhere;
  if (printed && (!result->output.empty() || example.exit_code != 0)) {
    data["output"] = output_data(result->output, are_proved(below, context),
                                 output_label(example, "this program"));
  }
  return data;
}

json data_of(const Exercise& exercise, const ExerciseResult& result, LessonContext& context) {
  json data = listing(result.starter, "cpp", context);
  data["id"] = context.unique_id(exercise_anchor(exercise));
  data["program"] = data["file"] = exercise_path(exercise);
  data["download"] = context.from_root(exercise_path(exercise));
  data["zip"] = context.from_root(exercise_zip_path(exercise));
  data["run"] = run_data(exercise, result, context);
  data["why_not"] = why_not_data(result);
  json checks = json::array();
  for (const Check& check : result.checks) checks.push_back(check.what);
  data["exercise"] = {
      {"checks", std::move(checks)},
      {"hidden", result.hidden.size()},
      {"solution", context.page.solutions ? json(context.from_root(exercise.program.file.text))
                                          : json(nullptr)},
      {"region", exercise.program.region->text},
      {"command", context.lesson.number + " " + exercise.program.name()}};
  return data;
}

json exercises_data(const LessonContext& context) {
  json all = json::array();
  const Callout* asked = nullptr;
  for (std::size_t i = 0; i < context.lesson.blocks.size(); ++i) {
    const Block& block = context.lesson.blocks[i];
    if (const auto* callout = std::get_if<Callout>(&block)) asked = callout;
    const auto* exercise = std::get_if<Exercise>(&block);
    const auto* result = context.results.get<ExerciseResult>(i);
    if (exercise == nullptr || result == nullptr) continue;
    if (run_data(*exercise, *result, context).is_null()) continue;
    const std::string title = asked != nullptr ? context.inline_html(asked->title) : "";
    all.push_back({{"id", exercise_anchor(*exercise)},
                   {"program", exercise_path(*exercise)},
                   {"title", title.empty() ? exercise->program.name() : title}});
  }
  return all;
}

json data_of(const Output& output, std::size_t index, const LessonContext& context) {
  const auto& example = std::get<Example>(context.lesson.blocks[output.example]);
  const auto* result = context.results.get<ExampleResult>(output.example);
  json data = listing("", "cpp", context);
  data["output"] =
      output_data(result != nullptr ? result->output : output.text.text,
                  are_proved({index}, context), output_label(example, example.file.text));
  return data;
}

json data_of(const Unchecked& unchecked, const LessonContext& context) {
  json data = listing(unchecked.code.text, unchecked.language, context);
  data["unchecked"] = true;
  data["because"] = unchecked.because;
  return data;
}

json data_of(const Snippet& snippet, std::size_t index, const LessonContext& context) {
  json data = listing(snippet.shown, "cpp", context);
  const auto* result = context.results.get<ExampleResult>(index);
  offer_program(snippet_program(context.lesson, index), result, context, data);
  if (result != nullptr && !result->output.empty()) {
    data["output"] =
        output_data(result->output, are_proved(outputs_below(snippet.outputs, context), context),
                    "Printed by these lines");
  }
  return data;
}

json data_of(const Commands& commands, std::size_t index, const LessonContext& context) {
  json data = listing(commands.code.text, "sh", context);
  const auto* result = context.results.get<ExampleResult>(index);
  // What they print on their way is for who runs them, unless the lesson speaks of it.
  const std::vector<std::size_t> below = outputs_below(commands.outputs, context);
  if (result != nullptr && !below.empty()) {
    data["output"] =
        output_data(result->output, are_proved(below, context), "Printed by these commands");
  }
  return data;
}

json data_of(const ModelExcerpt& excerpt, const LessonContext& context) {
  json data = listing(excerpt.text.text, "xml", context);
  data["file"] = "models/" + excerpt.model.text + ".xml";
  return data;
}

json data_of(const InlineModel& model, std::size_t index, const LessonContext& context) {
  json data = listing(model.text.text, "xml", context);
  const auto* result = context.results.get<ModelResult>(index);
  if (result != nullptr && !result->refusal.empty()) {
    data["output"] =
        output_data(result->refusal, false, "Said by MuJoCo, which refuses this model");
  }
  return data;
}

json data_of(const Image& image, const ImageResult& result, const LessonContext& context) {
  return {{"src", context.from_root(image_path(context.lesson, image, result))},
          {"alt", image.alt},
          {"width", result.width},
          {"height", result.height},
          {"source", image.title},
          {"alone", image.alone}};
}

json data_of(const Io& io, const LessonContext& context) {
  json rows = json::array();
  for (const Io::Row& row : io.rows) {
    rows.push_back({{"label", row.label}, {"html", context.inline_html(row.text)}});
  }
  return {{"rows", std::move(rows)}};
}

json data_of(const Demo& demo, const LessonContext& context) {
  return {{"source", context.page.highlighter.highlight(demo.source, "lesson")},
          {"body", context.html(demo.document)}};
}

json data_of(const Callout& callout, const std::string& inner, const LessonContext& context) {
  return {{"kind", callout.kind},
          {"label", capitalized(callout.kind)},
          {"title", context.inline_html(callout.title)},
          {"folds", callout.folded || callout.kind == "derivation"},
          {"open", !callout.folded},
          {"body", inner}};
}

}  // namespace mjcourse
