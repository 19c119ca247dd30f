// A text file as an author sees it: lines and columns.
//
// Whatever is read from a lesson keeps a Span of bytes; only when something is wrong does the span
// become a line, a column and an excerpt. Lines and columns count from 1; a column counts
// characters (Unicode code points), as editors do, not bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

// Bytes [begin, end) of a source text.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct Position {
  int line = 1;
  int column = 1;
};

class SourceText {
 public:
  // `path` is how messages name the file: relative to the course.
  SourceText(std::string path, std::string text);

  const std::string& path() const { return path_; }
  std::string_view text() const { return text_; }

  // An offset past the end is taken as the end, and one within a line's end as its beginning.
  Position position(std::size_t offset) const;
  // The bytes of line `line` (from 1) without its line end; empty past the last line.
  std::string_view line(int line) const;
  // The offset at which line `line` (from 1) begins; the text's size past the last line.
  std::size_t line_start(int line) const;
  int line_count() const { return static_cast<int>(starts_.size()); }

 private:
  std::string path_;
  std::string text_;
  // Characters of the text before byte `offset`.
  int characters_before(std::size_t offset) const;

  std::vector<std::size_t> starts_;  // of each line
  // Before each stretch of the text, where it has a line so long that to count it again and again
  // would take too long; else empty.
  std::vector<int> characters_;
};

}  // namespace mjcourse
