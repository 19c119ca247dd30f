#include "diagnostic_check.h"

#include "base/utf8.h"
#include "report/terminal.h"
#include "require.h"

namespace mjcourse {
namespace {

void check_line(const std::string& text, const std::string& what) {
  require(!find_invalid_utf8(text), what + " is UTF-8");
  require(text.find('\n') == text.npos, what + " is one line: " + text);
}

void check_place(const Place& place, const Sources& sources) {
  const auto source = sources.find(place.file);
  require(source != sources.end(), "the file was read: " + place.file);
  if (place.line == 0) return;  // the file as a whole
  const std::string at = place.file + ":" + std::to_string(place.line);
  require(place.line > 0 && place.line <= source->second.line_count(), "the line is there: " + at);
  require(!find_invalid_utf8(place.excerpt), "the excerpt is UTF-8: " + at);
  const std::string line(source->second.line(place.line));
  // A carriage return that only seems to end the line is one too.
  if (find_invalid_utf8(line) || find_control_character(line + " ")) {
    return require(!find_control_character(place.excerpt), "the excerpt is text: " + at);
  }
  const bool is_line = line.size() > 4000 ? line.find(place.excerpt) != line.npos  // a part of it
                                          : place.excerpt == line;
  require(is_line, "the excerpt is the line: " + at);
  const bool in_line = place.column >= 1 && place.column <= count_characters(line) + 1;
  require(in_line, "the column is in the line: " + at + ":" + std::to_string(place.column));
  require(place.width >= 1, "something is underlined: " + at);
}

}  // namespace

void check_diagnostics(const Diagnostics& diagnostics, const Sources& sources) {
  for (const Diagnostic& diagnostic : diagnostics) {
    require(diagnostic.id.size() > 2 && diagnostic.id[1] == '-', "an id: " + diagnostic.id);
    require(!diagnostic.message.empty(), diagnostic.id + " says something");
    check_line(diagnostic.message, "the message of " + diagnostic.id);
    check_line(diagnostic.cure, "the cure of " + diagnostic.id);
    check_place(diagnostic.place, sources);
    for (const Note& note : diagnostic.notes) {
      check_line(note.message, "a note of " + diagnostic.id);
      if (!note.place.file.empty()) check_place(note.place, sources);
    }
  }
}

std::string text_of(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += format_for_terminal(diagnostic);
  return text;
}

}  // namespace mjcourse
