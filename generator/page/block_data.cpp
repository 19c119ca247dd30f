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

}  // namespace

json PageWriter::data_of(const Example& example, std::size_t index) {
  const auto* result = results_.get<ExampleResult>(index);
  const std::string code = result != nullptr ? result->code : example.code.text;
  json data{{"id", "example-" + example.name()},
            {"file", example.file.text},
            {"code", press_.highlighter.highlight(code, "cpp")},
            {"download", "../" + example.file.text},
            {"output", nullptr}};
  if (result != nullptr && !result->output.empty()) {
    const bool proved = example.output && results_.get<OutputResult>(*example.output) != nullptr;
    data["output"] = {{"text", result->output}, {"proved", proved}};
  }
  return data;
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
