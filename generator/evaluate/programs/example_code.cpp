#include "evaluate/programs/example_code.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "evaluate/programs/region.h"
#include "lesson/syntax/exercise_text.h"
#include "process/our_command.h"

namespace mjcourse {
namespace {

std::string with_line_ends(const std::string& text, std::string_view line_end) {
  std::string written;
  for (const char c : text) {
    if (c == '\n') {
      written += line_end;
    } else if (c != '\r') {
      written += c;
    }
  }
  return written;
}

// The fence and the file differ: the first line of each that does.
Diagnostic difference(const Example& example, const std::string& file, const Lesson& lesson) {
  const std::string& path = example.file.text;
  const auto [ours, theirs] =
      std::mismatch(example.code.text.begin(), example.code.text.end(), file.begin(), file.end());
  const auto line = 1 + std::count(example.code.text.begin(), ours, '\n');
  const auto at = static_cast<std::size_t>(ours - example.code.text.begin());
  Diagnostic found = error_at(
      place_of(*lesson.source, example.file.span()), "E-example-file",
      "the fence and " + path + " differ, first in line " + std::to_string(line),
      "make them the same text: the fence is what a reader sees, the file what a learner builds");
  found.notes.push_back(
      {"the lesson has", place_of(*lesson.source, example.code.span(at, at + 1))});
  const SourceText source(path, file);
  const auto there = static_cast<std::size_t>(theirs - file.begin());
  found.notes.push_back({"the file has", place_of(source, {there, there + 1})});
  return found;
}

}  // namespace

std::optional<ExampleCode> code_of(const Example& example, const ShownProgram& shown,
                                   const Lesson& lesson,
                                   const tl::expected<std::string, std::string>& file,
                                   Diagnostics& diagnostics) {
  const bool empty = example.code.text.empty();
  if (!empty && file && without_exercise(*file) != *file) {
    diagnostics.push_back(error_at(place_of(*lesson.source, example.file.span()), "E-example-file",
                                   "the fence shows a program that is an exercise",
                                   "leave it empty: it shows the solution of " + example.file.text +
                                       ", which also has the starter"));
    return std::nullopt;
  }
  if (empty && file) return ExampleCode{{with_shown_regions(*file, shown), {}}, std::nullopt};
  const std::string text = with_line_ends(file.value_or(""), "\n");
  if (file && text == example.code.text) return ExampleCode{example.code, std::nullopt};
  if (file) {
    diagnostics.push_back(difference(example, text, lesson));
  } else {
    diagnostics.push_back(error_at(place_of(*lesson.source, example.file.span()), "E-example-file",
                                   "cannot read " + file.error(),
                                   empty ? "write it: the fence is empty, so its text is the file's"
                                         : "save the fence's text as " + example.file.text));
  }
  // What the lesson shows is still worth compiling.
  return empty ? std::nullopt : std::optional(ExampleCode{example.code, diagnostics.size() - 1});
}

void offer_file(const Example& example, const ShownProgram& shown, const Lesson& lesson,
                const tl::expected<std::string, std::string>& file, Diagnostic& differs) {
  const std::string& path = example.file.text;
  if (shown.contradicts_itself()) {
    differs.cure = "other fences show this file with other words: make them the same first";
    return;
  }
  const bool crlf = file && file->find("\r\n") != file->npos;
  const std::string accept = our_command("accept");
  differs.cure =
      file ? "the fence is what a reader sees, the file what a learner builds: " + accept +
                 " writes the fence's text into the file"
           : accept + " saves the fence's text as " + path;
  differs.edit = Edit{path, std::nullopt, with_line_ends(example.code.text, crlf ? "\r\n" : "\n"),
                      "the program that lesson " + lesson.number + " shows"};
  if (file) differs.edit->before = *file;
}

}  // namespace mjcourse
