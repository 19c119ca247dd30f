#include "evaluate/programs/region.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/nearest.h"
#include "evaluate/programs/region_lines.h"
#include "lesson/syntax/exercise_text.h"
#include "process/our_command.h"

namespace mjcourse {
namespace {

// The fence says something else than the region. Its first line that does is shown beside the
// region's.
Diagnostic difference(const Example& example, const std::vector<ProgramLine>& ours,
                      const Region& region, const SourceText& file, const Lesson& lesson) {
  const auto [mine, theirs] =
      std::mismatch(ours.begin(), ours.end(), region.lines.begin(), region.lines.end(),
                    [](const ProgramLine& a, const ProgramLine& b) { return a.text == b.text; });
  const auto line = static_cast<int>(mine - ours.begin()) + 1;
  Diagnostic found = error_at(place_of(*lesson.source, example.file.span()), "E-example-file",
                              "the fence and the region `" + example.region->text + "` of " +
                                  file.path() + " differ, first in line " + std::to_string(line),
                              "make them the same text, or leave the fence empty");
  const auto note = [&](const char* what, const SourceText& source, Span span) {
    found.notes.push_back({what, place_of(source, span)});
  };
  note("the lesson has", *lesson.source, example.code.span_at(line, 1, 1000));
  const int number = theirs != region.lines.end() ? theirs->number : region.lines.back().number + 1;
  const std::size_t start = file.line_start(number);
  note("the file has", file, {start, start + std::max<std::size_t>(1, file.line(number).size())});
  return found;
}

}  // namespace

std::string as_shown(std::string_view code) {
  const std::string solved = without_exercise(code);
  std::vector<ProgramLine> lines = program_lines(solved);
  std::erase_if(lines, is_region_mark);
  return joined(lines);
}

std::string with_shown_regions(std::string code, const ShownProgram& shown) {
  for (const Example* example : shown.regions) {
    const SourceText file(example->file.text, code);
    const auto region = find_region(program_lines(file.text()), example->region->text);
    if (example->code.text.empty() || !region || !region->closed) continue;
    const auto replacement = replace_region(file, *region, example->code.text);
    if (!replacement) continue;
    const Span span = replacement->span;
    code.replace(span.begin, span.end - span.begin, replacement->text);
  }
  return code;
}

std::optional<std::string> evaluate_region(const Example& example, const SourceText& program,
                                           bool may_edit, const Lesson& lesson,
                                           Diagnostics& diagnostics) {
  const std::vector<ProgramLine> lines = program_lines(program.text());
  const auto refuse = [&](const std::string& message, const std::string& cure) {
    diagnostics.push_back(error_at(place_of(*lesson.source, example.region->span()),
                                   "E-example-region", message, cure));
    return std::nullopt;
  };
  const std::optional<Region> region = find_region(lines, example.region->text);
  if (!region) {
    const std::vector<std::string> known = region_names(lines);
    return refuse(program.path() + " has no region `" + example.region->text + "`",
                  known.empty() ? "put it between lines `// #region NAME` and `// #endregion`"
                                : suggest(example.region->text, known));
  }
  if (!region->closed || region->lines.empty()) {
    return refuse("the region `" + example.region->text + "` of " + program.path() +
                      (region->closed ? " is empty" : " is never closed"),
                  region->closed ? "" : "end it with a line `// #endregion`");
  }
  std::vector<ProgramLine> ours = program_lines(example.code.text);
  take_indentation(ours);
  if (ours.empty() || joined(ours) == joined(region->lines)) return joined(region->lines);

  Diagnostic differs = difference(example, ours, *region, program, lesson);
  const auto replacement =
      may_edit ? replace_region(program, *region, example.code.text) : std::nullopt;
  if (replacement) {
    differs.cure =
        our_command("accept") + " writes the fence's lines into the file; or leave the fence empty";
    differs.edit =
        Edit{program.path(), replacement->span, replacement->text,
             "the region `" + example.region->text + "` that lesson " + lesson.number + " shows",
             std::string(program.text())};
  }
  diagnostics.push_back(std::move(differs));
  return replacement ? std::optional(joined(ours)) : std::nullopt;
}

}  // namespace mjcourse
