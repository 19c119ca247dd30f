#include "evaluate/programs/page_output.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "evaluate/programs/output_diff.h"
#include "findings/snippet_program.h"
#include "report/diff_text.h"

namespace mjcourse {
namespace {

constexpr const char* kCureOfOutput =
    "print what depends on no last digit, no size of a type and no C library; or say in the fence "
    "that no page runs it, and why: `native because=\"…\"`";

constexpr const char* kCureOfEnd =
    "do what a page can do as well (A.12 says what it cannot); or say in the fence that no page "
    "runs "
    "it, and why: `native because=\"…\"`";

// Is the page's text one that the lesson states?
bool is_stated(const Example& example, const std::string& page, const Lesson& lesson) {
  return std::ranges::any_of(example.outputs, [&](std::size_t index) {
    const auto& output = std::get<Output>(lesson.blocks[index]);
    Retrials retrials;
    return output_changes(output.text.text, page, output.tolerance, retrials).empty();
  });
}

std::optional<double> tolerance_of(const Example& example, const Lesson& lesson) {
  if (example.outputs.empty()) return std::nullopt;
  return std::get<Output>(lesson.blocks[example.outputs.front()]).tolerance;
}

// The first of these lines of one text; "nothing" where there is none.
std::string first_line(const std::vector<DiffLine>& changes, DiffLine::Kind kind) {
  const auto line = std::ranges::find(changes, kind, &DiffLine::kind);
  return line == changes.end() ? "nothing" : "`" + line->text + "`";
}

}  // namespace

void compare_page_run(const Example& example, const PageRun& page, const Lesson& lesson,
                      Diagnostics& diagnostics) {
  if (!page.why_not.empty()) return;
  const std::string kind = is_snippet_program(example) ? "snippet" : "program";
  const auto report = [&](const std::string& what, const char* cure) -> Diagnostic& {
    return diagnostics.emplace_back(error_at(place_of(*lesson.source, example.span),
                                             "E-page-output",
                                             "in the page, the " + kind + " " + what, cure));
  };
  if (!page.otherwise.empty()) {
    report(page.otherwise, kCureOfEnd);
    return;
  }
  if (!page.outputs || is_stated(example, page.outputs->page, lesson)) return;
  const std::optional<double> tolerance = tolerance_of(example, lesson);
  Retrials retrials;
  const std::vector<DiffLine> changes =
      output_changes(page.outputs->native, page.outputs->page, tolerance, retrials);
  if (changes.empty()) return;
  report("prints something else: " + first_line(changes, DiffLine::Kind::come) + " instead of " +
             first_line(changes, DiffLine::Kind::gone) + ", in line " +
             std::to_string(changes.front().line),
         kCureOfOutput)
      .detail = diff_text(changes, [&](std::string_view native, std::string_view there) {
    return lines_agree(native, there, tolerance, retrials);
  });
}

}  // namespace mjcourse
