#include "report/terminal.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "base/utf8.h"
#include "report/colours.h"

namespace mjcourse {
namespace {

class Writer {
 public:
  explicit Writer(const TerminalStyle& style) : style_(style) {}

  void coloured(std::string_view colour, std::string_view text) {
    if (style_.colours) out_ << colour;
    out_ << text;
    if (style_.colours) out_ << kPlain;
  }

  void text(std::string_view text) { out_ << text; }

  // "file:line:column: "
  void location(const Place& place) {
    std::string text = place.file;
    if (place.line > 0) text += ":" + std::to_string(place.line);
    if (place.column > 0) text += ":" + std::to_string(place.column);
    coloured(kBold, text + ": ");
  }

  void excerpt(const Place& place);
  void indented(std::string_view lines);

  std::string take() const { return out_.str(); }

 private:
  TerminalStyle style_;
  std::ostringstream out_;
};

// Byte offset of character `index` (from 0) of `text`.
std::size_t byte_of(std::string_view text, int index) {
  std::size_t at = 0;
  while (at < text.size() && count_characters(text.substr(0, at + 1)) <= index) ++at;
  return at;
}

void Writer::excerpt(const Place& place) {
  if (place.line == 0 || place.column == 0) return;
  std::string line = place.excerpt;
  std::replace(line.begin(), line.end(), '\t', ' ');
  const std::string number = std::to_string(place.line);
  const int room = std::max(20, style_.width - static_cast<int>(number.size()) - 6);
  int before = place.column - 1;
  // Keep the caret in sight: a third of the room before it, the rest after.
  if (count_characters(line) > room) {
    const int first = std::clamp(before - room / 3, 0, std::max(0, count_characters(line) - room));
    const std::size_t begin = byte_of(line, first);
    const std::size_t end = byte_of(line, first + room);
    const bool cut_after = end < line.size();
    line = (first > 0 ? "…" : "") + line.substr(begin, end - begin) + (cut_after ? "…" : "");
    before += (first > 0 ? 1 : 0) - first;
  }
  out_ << "  " << number << " | " << line << '\n';
  const int rest = std::max(1, count_characters(line) - before);
  const int tail = std::clamp(place.width, 1, rest) - 1;
  const std::string marks = "^" + std::string(static_cast<std::size_t>(tail), '~');
  out_ << "  " << std::string(number.size(), ' ') << " | "
       << std::string(static_cast<std::size_t>(before), ' ');
  coloured(kGreen, marks);
  out_ << '\n';
}

void Writer::indented(std::string_view lines) {
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    const std::string_view line = lines.substr(0, end);
    out_ << (line.empty() ? "" : "    ") << line << '\n';
    lines = end == std::string_view::npos ? std::string_view() : lines.substr(end + 1);
  }
}

}  // namespace

std::string format_for_terminal(const Diagnostic& diagnostic, const TerminalStyle& style) {
  Writer out(style);
  const bool error = diagnostic.severity == Severity::error;
  out.location(diagnostic.place);
  out.coloured(error ? kRed : kYellow, error ? "error: " : "warning: ");
  out.text(diagnostic.message + " [" + diagnostic.id + "]\n");
  out.excerpt(diagnostic.place);
  out.indented(diagnostic.detail);
  for (const Note& note : diagnostic.notes) {
    out.text("  note: ");
    if (!note.place.file.empty()) out.location(note.place);
    out.text(note.message + "\n");
    out.excerpt(note.place);
  }
  if (!diagnostic.cure.empty()) {
    out.coloured(kBold, "  cure: ");
    out.text(diagnostic.cure + "\n");
  }
  return out.take();
}

}  // namespace mjcourse
