#include "evaluate/programs/output_edit.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace mjcourse {
namespace {

// The fence in its file.
class FenceLines {
 public:
  FenceLines(const Output& output, const SourceText& source)
      : source_(source),
        opening_(source.position(output.span.begin).line),
        closing_(source.position(output.text.offsets.back()).line),
        fence_(output.span.begin - source.line_start(opening_)) {
    const std::string_view line = source.line(opening_);
    mark_ = line[fence_];
    length_ = std::min(line.find_first_not_of(mark_, fence_), line.size()) - fence_;
    // Of a fence that was left empty, nothing stays.
    const bool empty = output.text.text.find_first_not_of(" \t\n") == std::string::npos;
    body_lines_ = empty ? 0 : closing_ - opening_ - 1;
    line_end_ = raw(opening_).ends_with("\r\n") ? "\r\n" : "\n";
  }

  Span span() const { return {source_.line_start(opening_), source_.line_start(closing_ + 1)}; }
  int body_lines() const { return body_lines_; }
  std::string body_line(int line) const { return std::string(raw(opening_ + line)); }

  // `text` as a line of the body: behind the marks of quotes, and spaces where a list's mark
  // stands.
  std::string new_line(const std::string& text) const {
    const std::string_view line = source_.line(opening_);
    std::string front(line.substr(0, fence_));
    if (line.starts_with("[^")) front = "    ";  // a footnote's lines stand four columns in
    for (char& c : front) {
      if (c != '>' && c != '\t') c = ' ';
    }
    std::string written = front + text;
    written.erase(written.find_last_not_of(" \t") + 1);
    return written + line_end_;
  }

  // How many marks more the fence needs around `text`, in which it must not end and, as nobody
  // would mean it, no other may seem to begin.
  std::size_t missing_marks(const std::string& text) const {
    const std::size_t first = text.find_first_not_of(" \t>");
    if (first == text.npos || text[first] != mark_) return 0;
    const std::size_t run = std::min(text.find_first_not_of(mark_, first), text.size()) - first;
    return run >= length_ ? run + 1 - length_ : 0;
  }

  // The lines of the fence itself, with so many marks more.
  std::string opening(std::size_t more) const {
    std::string line(raw(opening_));
    return line.insert(fence_, more, mark_);
  }
  std::string closing(std::size_t more) const {
    std::string line(raw(closing_));
    return line.insert(line.rfind(mark_), more, mark_);
  }

 private:
  // A line with its end.
  std::string_view raw(int line) const {
    const std::size_t begin = source_.line_start(line);
    return source_.text().substr(begin, source_.line_start(line + 1) - begin);
  }

  const SourceText& source_;
  int opening_, closing_, body_lines_;
  std::size_t fence_;  // where the marks begin on their line
  char mark_ = '`';
  std::size_t length_ = 3;
  std::string line_end_;
};

std::string what(const Output& output, const Lesson& lesson) {
  const auto* example = std::get_if<Example>(&lesson.blocks[output.example]);
  if (example != nullptr) return "the output of " + example->name();
  return std::holds_alternative<Commands>(lesson.blocks[output.example])
             ? "the output of the commands"
             : "the output of the snippet";
}

}  // namespace

Edit output_edit(const Output& output, const std::vector<DiffLine>& changes, const Lesson& lesson) {
  const FenceLines fence(output, *lesson.source);
  std::string body;
  std::size_t more = 0;
  auto change = changes.begin();
  for (int line = 1; line <= fence.body_lines() + 1; ++line) {
    bool gone = false;
    for (; change != changes.end() && change->line == line; ++change) {
      if (change->kind == DiffLine::Kind::gone) {
        gone = true;
        continue;
      }
      body += fence.new_line(change->text);
      more = std::max(more, fence.missing_marks(change->text));
    }
    if (!gone && line <= fence.body_lines()) body += fence.body_line(line);
  }
  return {lesson.source->path(), fence.span(), fence.opening(more) + body + fence.closing(more),
          what(output, lesson), std::string(lesson.source->text())};
}

}  // namespace mjcourse
