#include "evaluate/region.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/nearest.h"

namespace mjcourse {
namespace {

constexpr std::string_view kBegin = "// #region ", kEnd = "// #endregion";

struct Line {
  int number;
  std::string_view text;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back({number, text.substr(0, end)});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

bool begins(const Line& line) {
  return trimmed(line.text).starts_with(kBegin);
}

bool ends(const Line& line) {
  return trimmed(line.text).starts_with(kEnd);
}

std::string name_of(const Line& line) {
  return std::string(trimmed(trimmed(line.text).substr(kBegin.size())));
}

// What all lines that are not blank have in front is taken off each.
void take_indentation(std::vector<Line>& lines) {
  std::size_t common = std::string_view::npos;
  for (const Line& line : lines) common = std::min(common, line.text.find_first_not_of(" \t\r"));
  for (Line& line : lines) line.text.remove_prefix(std::min(common, line.text.size()));
}

struct Region {
  std::vector<Line> lines;
  bool closed = false;
};

// Regions may hold others, whose marks are left out.
Region read_region(const std::vector<Line>& lines, std::vector<Line>::const_iterator begin) {
  Region region;
  int depth = 1;
  for (auto line = begin + 1; line != lines.end(); ++line) {
    if (begins(*line)) {
      ++depth;
    } else if (!ends(*line)) {
      region.lines.push_back(*line);
    } else if (--depth == 0) {
      region.closed = true;
      break;
    }
  }
  take_indentation(region.lines);
  return region;
}

std::string joined(const std::vector<Line>& lines) {
  std::string text;
  for (const Line& line : lines) text += std::string(line.text) + "\n";
  return text;
}

// The fence says something else than the region. Its first line that does is shown beside the
// region's.
Diagnostic difference(const Example& example, const std::vector<Line>& ours, const Region& region,
                      const SourceText& file, const Lesson& lesson) {
  const auto [mine, theirs] =
      std::mismatch(ours.begin(), ours.end(), region.lines.begin(), region.lines.end(),
                    [](const Line& a, const Line& b) { return a.text == b.text; });
  const auto line = static_cast<int>(mine - ours.begin()) + 1;
  Diagnostic found = error_at(place_of(*lesson.source, example.file.span()), "E-example-file",
                              "the fence and the region `" + example.region->text + "` of " +
                                  file.path() + " differ, first in line " + std::to_string(line),
                              "make them the same text, or leave the fence empty");
  const auto note = [&](const char* who, const SourceText& source, Span span) {
    found.notes.push_back({who, place_of(source, span)});
  };
  note("the lesson has", *lesson.source, example.code.span_at(line, 1, 1000));
  const int number = theirs != region.lines.end() ? theirs->number : region.lines.back().number + 1;
  const std::size_t start = file.line_start(number);
  note("the file has", file, {start, start + std::max<std::size_t>(1, file.line(number).size())});
  return found;
}

}  // namespace

std::string without_region_marks(std::string_view code) {
  std::vector<Line> lines = lines_of(code);
  std::erase_if(lines, [](const Line& line) { return begins(line) || ends(line); });
  return joined(lines);
}

std::optional<std::string> evaluate_region(const Example& example, const Lesson& lesson,
                                           const std::filesystem::path& root,
                                           Diagnostics& diagnostics) {
  const auto bytes = DiskFiles(root).read(example.file.text);
  if (!bytes) return std::nullopt;  // reported where the program is run
  const SourceText file(example.file.text, *bytes);
  const std::vector<Line> lines = lines_of(file.text());
  const auto refuse = [&](const std::string& message, const std::string& cure) {
    diagnostics.push_back(error_at(place_of(*lesson.source, example.region->span()),
                                   "E-example-region", message, cure));
    return std::nullopt;
  };
  const auto begin = std::find_if(lines.begin(), lines.end(), [&](const Line& line) {
    return begins(line) && name_of(line) == example.region->text;
  });
  if (begin == lines.end()) {
    std::vector<std::string> known;
    for (const Line& line : lines) {
      if (begins(line)) known.push_back(name_of(line));
    }
    return refuse(file.path() + " has no region `" + example.region->text + "`",
                  known.empty() ? "put it between lines `// #region NAME` and `// #endregion`"
                                : suggest(example.region->text, known));
  }
  const Region region = read_region(lines, begin);
  if (!region.closed || region.lines.empty()) {
    return refuse("the region `" + example.region->text + "` of " + file.path() +
                      (region.closed ? " is empty" : " is never closed"),
                  region.closed ? "" : "end it with a line `// #endregion`");
  }
  std::vector<Line> ours = lines_of(example.code.text);
  take_indentation(ours);
  if (!ours.empty() && joined(ours) != joined(region.lines)) {
    diagnostics.push_back(difference(example, ours, region, file, lesson));
    return std::nullopt;
  }
  return joined(region.lines);
}

}  // namespace mjcourse
