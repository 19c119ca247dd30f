// The data that each block's template is fed with; the templates' own comments describe it.
// Tested by tests/generator/page/blocks/page_writer_test.cpp.
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <utility>

#include "page/blocks/page_writer.h"
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

}  // namespace

json PageWriter::data_of(const Example& example, std::size_t index) {
  const auto* result = results_.get<ExampleResult>(index);
  json data = listing(result != nullptr ? result->code : example.code.text, "cpp");
  data["id"] = unique_id(example_anchor(example));
  data["file"] = example.file.text;
  data["download"] = from_root(example.file.text);
  if (const std::string zip = program_zip_path(example, result); !zip.empty()) {
    data["zip"] = from_root(zip);
  }
  // Of a program's regions, those have its output that say so; and where it is stated somewhere
  // else alone, that is where a reader finds it.
  const std::vector<std::size_t> below = outputs_below(example.outputs);
  const bool elsewhere = below.empty() && (example.region || !example.outputs.empty());
  const bool printed = result != nullptr && !elsewhere;
  if (printed && (!result->output.empty() || example.exit_code != 0)) {
    data["output"] =
        output_data(result->output, are_proved(below), output_label(example, "this program"));
  }
  return data;
}

json PageWriter::data_of(const Output& output, std::size_t index) {
  const auto& example = std::get<Example>(lesson_.blocks[output.example]);
  const auto* result = results_.get<ExampleResult>(output.example);
  json data = listing("", "cpp");
  data["output"] = output_data(result != nullptr ? result->output : output.text.text,
                               are_proved({index}), output_label(example, example.file.text));
  return data;
}

json PageWriter::data_of(const Unchecked& unchecked) {
  json data = listing(unchecked.code.text, unchecked.language);
  data["unchecked"] = true;
  data["because"] = unchecked.because;
  return data;
}

json PageWriter::data_of(const Snippet& snippet, std::size_t index) {
  json data = listing(snippet.shown, "cpp");
  const auto* result = results_.get<ExampleResult>(index);
  if (result != nullptr && !result->output.empty()) {
    data["output"] = output_data(result->output, are_proved(outputs_below(snippet.outputs)),
                                 "Printed by these lines");
  }
  return data;
}

json PageWriter::data_of(const Commands& commands, std::size_t index) {
  json data = listing(commands.code.text, "sh");
  const auto* result = results_.get<ExampleResult>(index);
  // What they print on their way is for who runs them, unless the lesson speaks of it.
  const std::vector<std::size_t> below = outputs_below(commands.outputs);
  if (result != nullptr && !below.empty()) {
    data["output"] = output_data(result->output, are_proved(below), "Printed by these commands");
  }
  return data;
}

json PageWriter::data_of(const ModelExcerpt& excerpt) {
  json data = listing(excerpt.text.text, "xml");
  data["file"] = "models/" + excerpt.model.text + ".xml";
  return data;
}

json PageWriter::data_of(const InlineModel& model, std::size_t index) {
  json data = listing(model.text.text, "xml");
  const auto* result = results_.get<ModelResult>(index);
  if (result != nullptr && !result->refusal.empty()) {
    data["output"] =
        output_data(result->refusal, false, "Said by MuJoCo, which refuses this model");
  }
  return data;
}

json PageWriter::listing(const std::string& code, const std::string& language) {
  const json highlighted =
      code.empty() ? json() : json(context_.highlighter.highlight(code, language));
  return {{"id", nullptr},       {"file", nullptr},    {"download", nullptr}, {"zip", nullptr},
          {"code", highlighted}, {"unchecked", false}, {"because", ""},       {"output", nullptr}};
}

std::vector<std::size_t> PageWriter::outputs_below(const std::vector<std::size_t>& outputs) const {
  std::vector<std::size_t> below;
  for (const std::size_t index : outputs) {
    if (!std::get<Output>(lesson_.blocks[index]).apart) below.push_back(index);
  }
  return below;
}

bool PageWriter::are_proved(const std::vector<std::size_t>& outputs) const {
  return !outputs.empty() && std::all_of(outputs.begin(), outputs.end(), [this](std::size_t index) {
    return results_.get<OutputResult>(index) != nullptr;
  });
}

std::string PageWriter::unique_id(const std::string& wanted) {
  const auto is_taken = [this](const std::string& id) {
    return ids_.contains(id) ||
           std::any_of(lesson_.headings.begin(), lesson_.headings.end(),
                       [&](const Heading& heading) { return heading.id == id; });
  };
  std::string id = wanted;
  for (int n = 2; is_taken(id); ++n) id = wanted + "-" + std::to_string(n);
  ids_.insert(id);
  return id;
}

json PageWriter::data_of(const Image& image, const ImageResult& result) const {
  return {{"src", from_root(image_path(lesson_, image, result))},
          {"alt", image.alt},
          {"width", result.width},
          {"height", result.height},
          {"source", image.title},
          {"alone", image.alone}};
}

json PageWriter::data_of(const Io& io) const {
  json rows = json::array();
  for (const Io::Row& row : io.rows) {
    rows.push_back({{"label", row.label}, {"html", inline_html(row.text)}});
  }
  return {{"rows", std::move(rows)}};
}

json PageWriter::data_of(const Demo& demo) {
  return {{"source", context_.highlighter.highlight(demo.source, "lesson")},
          {"body", html(demo.document)}};
}

json PageWriter::data_of(const Callout& callout, const std::string& inner) const {
  return {{"kind", callout.kind},
          {"label", capitalized(callout.kind)},
          {"title", inline_html(callout.title)},
          {"folds", callout.folded || callout.kind == "derivation"},
          {"open", !callout.folded},
          {"body", inner}};
}

}  // namespace mjcourse
