#include "evaluate/output.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <string>

#include "evaluate/output_diff.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostLines = 20;  // of a diff

std::string count(std::ptrdiff_t lines) {
  return std::to_string(lines) + (lines == 1 ? " line" : " lines");
}

}  // namespace

std::optional<OutputResult> evaluate_output(const Output& output, const ExampleResult& example,
                                            const Lesson& lesson, Diagnostics& diagnostics) {
  const std::vector<LineChange> changes =
      output_changes(output.text.text, example.output, output.tolerance);
  if (changes.empty()) {
    const auto lines = std::count(example.output.begin(), example.output.end(), '\n');
    return OutputResult{static_cast<int>(lines)};
  }
  const int above = lesson.source->position(output.text.span(0, 0).begin).line - 1;
  const auto stated = std::count_if(changes.begin(), changes.end(), [](const LineChange& change) {
    return change.kind == LineChange::Kind::stated;
  });
  const std::ptrdiff_t real = static_cast<std::ptrdiff_t>(changes.size()) - stated;
  std::ostringstream diff;
  const int width = static_cast<int>(std::to_string(above + changes.back().line).size());
  for (std::size_t i = 0; i < std::min(changes.size(), kMostLines); ++i) {
    const bool in_lesson = changes[i].kind == LineChange::Kind::stated;
    diff << std::setw(width) << (in_lesson ? std::to_string(above + changes[i].line) : "")
         << (in_lesson ? " - " : " + ") << changes[i].text << '\n';
  }
  if (changes.size() > kMostLines) {
    diff << "… and " << changes.size() - kMostLines << " more\n";
  }
  const Span line = output.text.span_at(changes.front().line, 1, 1000);
  Diagnostic differs = error_at(place_of(*lesson.source, line), "E-output-differs",
                                "the program prints something else: " + count(stated) +
                                    " of the lesson (-), " + count(real) + " of the program (+)",
                                "if the program is right, put its lines here");
  differs.detail = diff.str();
  diagnostics.push_back(std::move(differs));
  return std::nullopt;
}

}  // namespace mjcourse
