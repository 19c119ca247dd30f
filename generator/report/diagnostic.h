// Diagnostic: what is wrong with a course, as data.
//
// Every part of the generator that can find a mistake of the author's makes one of these and goes
// on; text is made of it only at the edge (report/terminal.h). A stage takes a `Diagnostics&` and
// appends to it, so that all mistakes of a lesson are shown in one run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/source_text.h"

namespace mjcourse {

enum class Severity { error, warning };

// A stretch of one line of a file. Lines and columns count from 1, columns in characters; line 0
// means the file as a whole.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  int width = 1;           // characters to underline; what goes past the line's end is not drawn
  std::string excerpt;     // the source line; of one of kilobytes, what is around the column
  int excerpt_column = 1;  // of its first character
};

struct Note {
  std::string message;
  Place place;  // without a file: the note belongs to the diagnostic's own place
};

// What to write into a file so that it is no longer wrong; `mjcourse accept` does it.
struct Edit {
  std::string file;  // relative to the course
  std::optional<Span>
      span;          // the bytes to replace; nothing: the whole file, which may not be there
  std::string text;  // what comes there
  std::string what;  // "the output of l1_2_second_box", for the author, who is to agree
  std::optional<std::string> before = {};  // the file's bytes as they were read, where they were
};

struct Diagnostic {
  std::string id;  // stable, for search engines and `explain`: "E-output-differs"
  Severity severity = Severity::error;
  Place place;
  std::string message;  // one line: what is wrong, with the values that show it
  std::string detail;   // more lines where they help: a diff, the compiler's own words
  std::vector<Note> notes;
  std::string cure;               // what to do about it; empty when there is nothing to suggest
  std::optional<Edit> edit = {};  // where the course can be made right without its author's thought
};

using Diagnostics = std::vector<Diagnostic>;

// An error with what every error has; set the rest where there is more to say. What message and
// cure quote of the author's may hold anything: they become one line (base/utf8.h: readable).
Diagnostic error_at(Place place, std::string id, std::string message, std::string cure = "");

// In the order of the files and of their lines, whichever thread found them first.
void sort_by_place(Diagnostics& diagnostics);

// Does it stand in `file`, or say in a note that this has a part in it: a lesson that uses the
// model?
bool concerns(const Diagnostic& diagnostic, const std::string& file);

// The place of `span` in `source`; a span over several lines is cut at the end of its first.
Place place_of(const SourceText& source, Span span);

}  // namespace mjcourse
