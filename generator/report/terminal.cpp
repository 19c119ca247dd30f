#include "report/terminal.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <vector>

#include "base/utf8.h"
#include "process/our_command.h"
#include "report/colours.h"
#include "report/wrapped.h"

namespace mjcourse {
namespace {

// A source line as it is shown, and where the marks below it stand, in columns.
struct Shown {
  std::string line;
  int before = 0, marks = 1;
};

class DiagnosticWriter {
 public:
  explicit DiagnosticWriter(const TerminalStyle& style) : style_(style) {}

  void coloured(std::string_view colour, std::string_view text) {
    if (style_.colours) out_ << colour;
    out_ << text;
    if (style_.colours) out_ << kPlain;
    column_ += count_columns(text);
  }

  void text(std::string_view text) {
    out_ << text;
    column_ += count_columns(text);
  }

  // To the end of the line, or over several, of which all but the first stand behind `indent`.
  void sentence(std::string_view text, int indent) {
    out_ << (style_.wraps ? wrapped(text, style_.width, indent, column_) : std::string(text))
         << '\n';
    column_ = 0;
  }

  // "file:line:column: "
  void location(const Place& place) {
    std::string text = readable(place.file);
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
  int column_ = 0;  // of the line that is being written
};

// The line of `place`; where `room` columns cannot hold it, only what is around the caret: a third
// of the room before it, the rest behind.
Shown shown(const Place& place, int room) {
  const std::string line = with_marks_for_unreadable(place.excerpt);
  const std::vector<std::string_view> characters = characters_of(line);
  std::vector<int> starts{0};  // the column where each begins, and where the last one ends
  for (const std::string_view one : characters)
    starts.push_back(starts.back() + count_columns(one));
  const auto column_of = [&](int index) {
    const int past_end = std::max(0, index - static_cast<int>(characters.size()));
    return starts[static_cast<std::size_t>(index - past_end)] + past_end;
  };
  const int index = place.column - place.excerpt_column;
  const int caret = column_of(index);
  const int end = std::max(caret + 1, column_of(index + std::max(1, place.width)));
  const int all = starts.back();
  if (all <= room) return {line, caret, std::max(1, std::min(end, all) - caret)};

  const int from = std::clamp(caret - room / 3, 0, all - room);
  int first = all, last = 0;  // the columns that are shown
  std::string part;
  for (std::size_t i = 0; i < characters.size(); ++i) {
    if (starts[i] < from || starts[i + 1] > from + room) continue;
    first = std::min(first, starts[i]);
    last = starts[i + 1];
    part += characters[i];
  }
  const int cut_before = first > 0 ? 1 : 0, cut_behind = last < all ? 1 : 0;
  return {(cut_before ? "…" : "") + part + (cut_behind ? "…" : ""), caret - first + cut_before,
          std::max(1, std::min(end, last + cut_behind) - caret)};
}

void DiagnosticWriter::excerpt(const Place& place) {
  if (place.line == 0 || place.column == 0) return;
  const std::string number = std::to_string(place.line);
  const auto [line, before, marks] =
      shown(place, std::max(20, style_.width - static_cast<int>(number.size()) - 6));
  out_ << "  " << number << " | " << line << '\n'
       << "  " << std::string(number.size(), ' ') << " | "
       << std::string(static_cast<std::size_t>(before), ' ');
  coloured(kGreen, "^" + std::string(static_cast<std::size_t>(marks - 1), '~'));
  out_ << '\n';
  column_ = 0;
}

void DiagnosticWriter::indented(std::string_view lines) {
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    const std::string_view line = lines.substr(0, end);
    out_ << (line.empty() ? "" : "    ") << readable_output(line) << '\n';
    lines = end == std::string_view::npos ? std::string_view() : lines.substr(end + 1);
  }
}

}  // namespace

std::string format_for_terminal(const Diagnostic& diagnostic, const TerminalStyle& style) {
  constexpr int indent = 4;
  DiagnosticWriter out(style);
  const bool error = diagnostic.severity == Severity::error;
  out.location(diagnostic.place);
  out.coloured(error ? kRed : kYellow, error ? "error: " : "warning: ");
  out.sentence(readable(diagnostic.message) + " [" + diagnostic.id + "]", indent);
  out.excerpt(diagnostic.place);
  out.indented(diagnostic.detail);
  for (const Note& note : diagnostic.notes) {
    out.text("  note: ");
    if (!note.place.file.empty()) out.location(note.place);
    out.sentence(readable(note.message), indent);
    out.excerpt(note.place);
  }
  if (!diagnostic.cure.empty()) {
    out.coloured(kBold, "  cure: ");
    out.sentence(readable(diagnostic.cure), indent);
  }
  return out.take();
}

std::string format_for_terminal(const Diagnostics& diagnostics, const TerminalStyle& style) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    text += format_for_terminal(diagnostic, style) + "\n";
  }
  if (style.wraps && !diagnostics.empty()) {
    text += our_command("explain " + diagnostics.front().id) + " tells more of a message\n\n";
  }
  return text;
}

}  // namespace mjcourse
