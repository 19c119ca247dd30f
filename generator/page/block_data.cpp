// The data that each block's template is fed with; the templates' own comments describe it.
#include <cctype>
#include <cmath>
#include <cstdio>
#include <utility>

#include "page/page_writer.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr int kTraceDigits = 4;

// `value` with `digits` after its point, and never "-0.0".
std::string fixed(double value, int digits) {
  char text[400];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  const bool zero = std::string(text).find_first_of("123456789") == std::string::npos;
  return zero && text[0] == '-' ? text + 1 : text;
}

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

json PageWriter::data_of(const Lab& lab, std::size_t index) {
  const auto* result = results_.get<LabResult>(index);
  ++labs_;
  json data{{"id", "lab-" + std::to_string(labs_)},
            {"title", lab.title},
            {"dock", lab.dock},
            {"height", lab.height},
            {"poster", nullptr},
            {"controls", json::array()},
            {"readouts", json::array()},
            {"plots", json::array()},
            {"toggles", json::array()},
            {"note", inline_html(lab.note)}};
  if (result != nullptr && result->poster) {
    const std::string path = "../" + poster_path(lesson_, labs_);
    data["poster"] = {{"webp", path + ".webp"},
                      {"png", path + ".png"},
                      {"width", result->poster->width},
                      {"height", result->poster->height},
                      {"alt", "The lab \u201c" + lab.title + "\u201d before it is played"}};
  }
  for (const Lab::Button& button : lab.controls) {
    data["controls"].push_back({{"kind", "button"}, {"label", button.label.text}});
  }
  for (std::size_t i = 0; result != nullptr && i < lab.readouts.size(); ++i) {
    const Lab::Readout& readout = lab.readouts[i];
    data["readouts"].push_back({{"label", readout.label.text},
                                {"value", fixed(result->readouts[i], readout.digits)},
                                {"unit", readout.unit}});
  }
  for (std::size_t p = 0; result != nullptr && p < lab.plots.size(); ++p) {
    json traces = json::array();
    for (std::size_t t = 0; t < lab.plots[p].traces.size(); ++t) {
      traces.push_back({{"label", lab.plots[p].traces[t].label.text},
                        {"value", fixed(result->traces[p][t], kTraceDigits)}});
    }
    data["plots"].push_back({{"ylabel", lab.plots[p].ylabel}, {"traces", std::move(traces)}});
  }
  for (const LocatedText& toggle : lab.toggles) {
    bool on = false;
    for (const Lab::Overlay& overlay : lab.overlays) {
      if (overlay.name.text == toggle.text) on = overlay.on;
    }
    data["toggles"].push_back({{"name", toggle.text}, {"on", on}});
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
