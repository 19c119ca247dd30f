#include "evaluate/programs/output.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/counted.h"
#include "evaluate/programs/output_diff.h"
#include "evaluate/programs/output_edit.h"
#include "process/our_command.h"
#include "report/diff_text.h"

namespace mjcourse {
namespace {

// What differs, in one line, at the first line of the lesson that does.
Diagnostic differs(const Output& output, const std::vector<DiffLine>& changes,
                   const Lesson& lesson) {
  const auto gone = std::count_if(changes.begin(), changes.end(), [](const DiffLine& change) {
    return change.kind == DiffLine::Kind::gone;
  });
  const std::ptrdiff_t come = static_cast<std::ptrdiff_t>(changes.size()) - gone;
  if (output.text.text.find_first_not_of(" \t\n") == std::string::npos) {
    return error_at(
        place_of(*lesson.source, output.span), "E-output-differs",
        "this output is empty, and the program prints " + counted(come, "line") + " (+)",
        our_command("accept") + " writes them here");
  }
  const Span line = output.text.span_at(changes.front().line, 1, 1000);
  return error_at(place_of(*lesson.source, line), "E-output-differs",
                  "the program prints something else: " + counted(gone, "line") +
                      " of the lesson (-), " + counted(come, "line") + " of the program (+)",
                  "if the program is right, " + our_command("accept") + " writes its lines here");
}

// The lines may be as stated: what stands behind a `[..]` begins like too much of what is printed.
Diagnostic undecided(const Output& output, const Lesson& lesson) {
  const std::size_t gap = output.text.text.find("[..]");
  return error_at(
      place_of(*lesson.source, output.text.span(gap, gap + 4)), "E-output-gap",
      "finding what follows `[..]` would take too long: it may begin at too many places of a long "
      "line",
      "print shorter lines, or state more of them in front of `[..]`, and less after it");
}

}  // namespace

std::optional<OutputResult> evaluate_output(const Output& output, const ExampleResult& example,
                                            const Lesson& lesson, Diagnostics& diagnostics) {
  Retrials retrials;
  std::vector<DiffLine> changes =
      output_changes(output.text.text, example.output, output.tolerance, retrials);
  if (changes.empty()) {
    const auto lines = std::count(example.output.begin(), example.output.end(), '\n');
    return OutputResult{static_cast<int>(lines)};
  }
  if (retrials.left == 0) {
    diagnostics.push_back(undecided(output, lesson));
    return std::nullopt;
  }
  Diagnostic found = differs(output, changes, lesson);
  found.edit = output_edit(output, changes, lesson);
  const int above = lesson.source->position(output.span.begin).line;
  for (DiffLine& change : changes) change.line += above;
  found.detail = diff_text(changes, [&](std::string_view stated, std::string_view real) {
    return lines_agree(stated, real, output.tolerance, retrials);
  });
  diagnostics.push_back(std::move(found));
  return std::nullopt;
}

}  // namespace mjcourse
