// The data that each block's template is fed with; the templates' own comments describe it.
#include <cctype>
#include <utility>

#include "page/page_writer.h"

namespace mjcourse {
namespace {

using nlohmann::json;

std::string capitalized(std::string word) {
  if (!word.empty()) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  return word;
}

// How the text below a program came about.
std::string output_label(const Example& example) {
  if (!example.compiles) return "Said by the compiler, which refuses this program";
  std::string label = "Printed by this program";
  for (std::size_t i = 0; i < example.arguments.size(); ++i) {
    label += (i == 0 ? " when run with " : " ") + example.arguments[i];
  }
  if (example.exit_code == 0) return label;
  return label + ", which exits with code " + std::to_string(example.exit_code);
}

}  // namespace

json PageWriter::data_of(const Example& example, std::size_t index) {
  const auto* result = results_.get<ExampleResult>(index);
  json data = listing(result != nullptr ? result->code : example.code.text, "cpp");
  data["id"] = "example-" + example.name() + (example.region ? "-" + example.region->text : "");
  data["file"] = example.file.text;
  data["download"] = "../" + example.file.text;
  // Of a program's regions, those have its output that say so.
  const bool printed = result != nullptr && (!example.region || example.output);
  if (printed && (!result->output.empty() || example.exit_code != 0)) {
    data["output"] = {{"text", result->output},
                      {"proved", has_proved_output(example.output)},
                      {"label", output_label(example)}};
  }
  return data;
}

json PageWriter::data_of(const Unchecked& unchecked) {
  json data = listing(unchecked.code.text, "cpp");
  data["unchecked"] = true;
  return data;
}

json PageWriter::data_of(const Snippet& snippet, std::size_t index) {
  json data = listing(snippet.shown, "cpp");
  const auto* result = results_.get<ExampleResult>(index);
  if (result != nullptr && !result->output.empty()) {
    data["output"] = {{"text", result->output},
                      {"proved", has_proved_output(snippet.output)},
                      {"label", "Printed by these lines"}};
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
    data["output"] = {{"text", result->refusal},
                      {"proved", false},
                      {"label", "Said by MuJoCo, which refuses this model"}};
  }
  return data;
}

json PageWriter::listing(const std::string& code, const std::string& language) {
  return {{"id", nullptr},       {"file", nullptr},
          {"download", nullptr}, {"code", press_.highlighter.highlight(code, language)},
          {"unchecked", false},  {"output", nullptr}};
}

bool PageWriter::has_proved_output(const std::optional<std::size_t>& output) const {
  return output && results_.get<OutputResult>(*output) != nullptr;
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

json PageWriter::data_of(const Callout& callout, const std::string& inner) const {
  return {{"kind", callout.kind},
          {"label", capitalized(callout.kind)},
          {"title", inline_html(callout.title)},
          {"folds", callout.folded || callout.kind == "derivation"},
          {"open", !callout.folded},
          {"body", inner}};
}

}  // namespace mjcourse
