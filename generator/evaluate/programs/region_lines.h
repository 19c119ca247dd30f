// The lines of a region of a program: finding them, and putting others in their place.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/source_text.h"

namespace mjcourse {

struct ProgramLine {
  int number;  // in its text, from 1
  std::string_view text;
};

// `text` without its line ends.
std::vector<ProgramLine> program_lines(std::string_view text);
// What all lines that are not blank have in front is taken off each; gives it.
std::string take_indentation(std::vector<ProgramLine>& lines);
std::string joined(const std::vector<ProgramLine>& lines);

// Is this `// #region NAME` or `// #endregion`?
bool is_region_mark(const ProgramLine& line);
// The names of the regions that begin in `lines`.
std::vector<std::string> region_names(const std::vector<ProgramLine>& lines);

struct Region {
  std::vector<ProgramLine> lines;  // without their indentation, and without marks
  std::string indentation;
  bool closed = false;
  bool holds_marks = false;  // of regions inside it
};

// Nothing where there is no region of that name.
std::optional<Region> find_region(const std::vector<ProgramLine>& lines, const std::string& name);

// The bytes of a text to replace, and what with.
struct Replacement {
  Span span;
  std::string text;
};

// What makes the lines of `region`, which stands in `file`, those of `code`: only the lines that
// differ, with the region's indentation. Nothing where it holds marks, which no fence shows.
std::optional<Replacement> replace_region(const SourceText& file, const Region& region,
                                          std::string_view code);

}  // namespace mjcourse
