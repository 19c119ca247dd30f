#include "evaluate/programs/compile_errors.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr int kMostErrors = 5;  // of one program: later ones mostly follow from the first

// The length of the name that begins at `at`; at least 1.
std::size_t name_length(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && is_word_character(text[end])) ++end;
  return end > at ? end - at : 1;
}

// Of a message about `file`, whose first line the compiler counts as `first_line`.
Span span_in(const SourceText& file, int first_line, const CompilerMessage& message) {
  const std::size_t at =
      file.line_start(message.line - first_line + 1) + static_cast<std::size_t>(message.column) - 1;
  return {at, at + name_length(file.text(), at)};
}

Place place_of_message(const CompilerMessage& message, const CompiledText& text,
                       const Lesson& lesson) {
  if (text.code.offsets.empty()) {  // the program stands in its own file
    const SourceText file(text.name, text.code.text);
    return place_of(file, span_in(file, 1, message));
  }
  const Span span = span_in(SourceText("", text.code.text), text.first_line, message);
  return place_of(*lesson.source, text.code.span(span.begin, span.end));
}

// The place of a message about a header of the course at `root`; nothing of another header.
std::optional<Place> place_in_header(const CompilerMessage& message, const fs::path& root) {
  const fs::path path = fs::path(message.file)
                            .lexically_normal()
                            .lexically_relative(fs::absolute(root).lexically_normal());
  if (path.empty() || path.begin()->string() == "..") return std::nullopt;
  const auto bytes = DiskFiles(root).read(path.string());
  if (!bytes) return std::nullopt;
  const SourceText header(path.string(), *bytes);
  return place_of(header, span_in(header, 1, message));
}

// The line of the program that led to messages[index], which speaks of a header: the first note
// behind it that names the program ("in instantiation of … requested here").
const CompilerMessage* cause_of(const Compiled& compiled, std::size_t index,
                                const std::string& name) {
  for (std::size_t i = index + 1; i < compiled.messages.size(); ++i) {
    if (compiled.messages[i].severity != "note") break;
    if (compiled.messages[i].file == name) return &compiled.messages[i];
  }
  return nullptr;
}

// Where headers are looked for, where one was not found.
std::string cure_of(const CompilerMessage& message) {
  for (const char* missing :
       {" file not found", ": No such file or directory", ": Permission denied"}) {
    if (!message.text.ends_with(missing)) continue;
    return "a header of the course lies beside the program and is included as `\"name.h\"`, or in "
           "examples/include";
  }
  return "";
}

// What the compiler said, without the folder of the course.
std::string without_root(std::string text, const fs::path& root) {
  const std::string folder = fs::absolute(root).lexically_normal().string() + "/";
  for (std::size_t at = 0; (at = text.find(folder, at)) != text.npos;)
    text.erase(at, folder.size());
  return text;
}

// What the linker said, each thing once and without the names of temporary files.
std::string link_problems(const std::string& raw) {
  std::vector<std::string> problems;
  std::istringstream lines(raw);
  for (std::string line; std::getline(lines, line);) {
    for (const char* start : {"undefined reference to", "multiple definition of"}) {
      const std::size_t at = line.find(start);
      if (at == line.npos) continue;
      std::string problem = line.substr(at, line.find(';', at) - at);
      if (std::find(problems.begin(), problems.end(), problem) == problems.end()) {
        problems.push_back(std::move(problem));
      }
    }
  }
  if (problems.empty()) return raw.substr(0, 2000);
  std::string text;
  for (const std::string& problem : problems) text += problem + "\n";
  return text;
}

// Show `found`, which stands where the program led to it, in the header that `message` is about.
void show_header(const CompilerMessage& message, const fs::path& root, bool has_cause,
                 Diagnostic& found) {
  std::optional<Place> place = place_in_header(message, root);
  if (!place) {
    const std::string file = fs::path(message.file).lexically_normal().string();
    found.detail = "in " + file + ":" + std::to_string(message.line) + "\n";
  } else if (has_cause) {
    found.notes.push_back({"the compiler finds it in this header", *std::move(place)});
  } else {
    found.notes.push_back({"this program includes it", std::exchange(found.place, *place)});
  }
}

}  // namespace

void report_compile_messages(const Compiled& compiled, const CompiledText& text,
                             const Lesson& lesson, const fs::path& root, Diagnostics& diagnostics) {
  int errors = 0;
  for (std::size_t i = 0; i < compiled.messages.size(); ++i) {
    const CompilerMessage& message = compiled.messages[i];
    if (message.severity == "note") continue;
    const bool warning = message.severity == "warning";
    if (!warning && ++errors > kMostErrors) break;
    const bool own = message.file == text.name;
    const bool is_blank = message.text.find_first_not_of(' ') == message.text.npos;  // of #error
    const CompilerMessage* at = own ? &message : cause_of(compiled, i, text.name);
    Diagnostic found = error_at(
        at != nullptr ? place_of_message(*at, text, lesson) : place_of(*lesson.source, text.fence),
        warning ? "W-example-compile" : "E-example-compile",
        is_blank ? "the compiler gives no reason" : without_root(message.text, root),
        cure_of(message));
    found.severity = warning ? Severity::warning : Severity::error;
    if (!own) show_header(message, root, at != nullptr, found);
    if (text.code.offsets.empty()) {
      found.notes.push_back({"the lesson shows this file", place_of(*lesson.source, text.fence)});
    }
    diagnostics.push_back(std::move(found));
  }
  if (compiled.succeeded || errors > 0) return;
  if (!compiled.stopped.empty()) {
    diagnostics.push_back(error_at(place_of(*lesson.source, text.fence), "E-example-compile",
                                   "the compiler " + compiled.stopped,
                                   "look for what the compiler has to compute or to include"));
    return;
  }
  Diagnostic link = error_at(place_of(*lesson.source, text.fence), "E-example-compile",
                             "the program does not link");
  link.detail = link_problems(compiled.raw);
  diagnostics.push_back(std::move(link));
}

}  // namespace mjcourse
