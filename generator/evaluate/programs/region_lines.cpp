#include "evaluate/programs/region_lines.h"

#include <algorithm>

#include "base/text_lines.h"
#include "lesson/syntax/exercise_text.h"

namespace mjcourse {
namespace {

constexpr std::string_view kBegin = "// #region ", kEnd = "// #endregion";

bool begins(const ProgramLine& line) {
  return trimmed(line.text).starts_with(kBegin);
}

bool ends(const ProgramLine& line) {
  return trimmed(line.text).starts_with(kEnd);
}

std::string name_of(const ProgramLine& line) {
  return std::string(trimmed(trimmed(line.text).substr(kBegin.size())));
}

bool same_text(const ProgramLine& a, const ProgramLine& b) {
  return a.text == b.text;
}

}  // namespace

std::vector<ProgramLine> program_lines(std::string_view text) {
  std::vector<ProgramLine> lines;
  for (const std::string_view line : lines_of(text)) {
    lines.push_back({static_cast<int>(lines.size()) + 1, line});
  }
  return lines;
}

std::string take_indentation(std::vector<ProgramLine>& lines) {
  std::size_t common = std::string_view::npos;
  std::string_view indentation;
  for (const ProgramLine& line : lines) {
    const std::size_t first = line.text.find_first_not_of(" \t\r");
    if (first >= common) continue;
    common = first;
    indentation = line.text.substr(0, first);
  }
  for (ProgramLine& line : lines) line.text.remove_prefix(std::min(common, line.text.size()));
  return std::string(indentation);
}

std::string joined(const std::vector<ProgramLine>& lines) {
  std::string text;
  for (const ProgramLine& line : lines) text += std::string(line.text) + "\n";
  return text;
}

bool is_region_mark(const ProgramLine& line) {
  return begins(line) || ends(line);
}

std::vector<std::string> region_names(const std::vector<ProgramLine>& lines) {
  std::vector<std::string> names;
  for (const ProgramLine& line : lines) {
    if (begins(line)) names.push_back(name_of(line));
  }
  return names;
}

std::optional<Region> find_region(const std::vector<ProgramLine>& lines, const std::string& name) {
  auto line = std::find_if(lines.begin(), lines.end(), [&](const ProgramLine& candidate) {
    return begins(candidate) && name_of(candidate) == name;
  });
  if (line == lines.end()) return std::nullopt;
  Region region;
  int depth = 1;
  bool is_solution = true;  // of an exercise, which has more behind it
  for (++line; line != lines.end(); ++line) {
    if (begins_variant(line->text)) {
      is_solution = false;
    } else if (begins(*line)) {
      ++depth;
      region.holds_marks = true;
    } else if (!ends(*line)) {
      if (is_solution) region.lines.push_back(*line);
    } else if (--depth == 0) {
      region.closed = true;
      break;
    }
  }
  region.indentation = take_indentation(region.lines);
  return region;
}

std::optional<Replacement> replace_region(const SourceText& file, const Region& region,
                                          std::string_view code) {
  if (region.holds_marks || region.lines.empty()) return std::nullopt;
  std::vector<ProgramLine> ours = program_lines(code);
  take_indentation(ours);
  const std::vector<ProgramLine>& theirs = region.lines;
  const auto start =
      std::mismatch(ours.begin(), ours.end(), theirs.begin(), theirs.end(), same_text);
  const auto end =
      std::mismatch(ours.rbegin(), std::make_reverse_iterator(start.first), theirs.rbegin(),
                    std::make_reverse_iterator(start.second), same_text);
  const auto first = theirs.front().number + static_cast<int>(start.second - theirs.begin());
  const auto behind = theirs.front().number + static_cast<int>(end.second.base() - theirs.begin());
  Replacement replacement{{file.line_start(first), file.line_start(behind)}, ""};
  const bool crlf = file.text().substr(0, replacement.span.begin).ends_with("\r\n");
  for (auto line = start.first; line != end.first.base(); ++line) {
    if (!line->text.empty()) replacement.text += region.indentation + std::string(line->text);
    replacement.text += crlf ? "\r\n" : "\n";
  }
  return replacement;
}

}  // namespace mjcourse
