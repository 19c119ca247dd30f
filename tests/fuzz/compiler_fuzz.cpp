// What a compiler says, of any bytes, about a program in a lesson; and the list of the files it
// read.
//
// The input: the program, a line `=====`, what was said.
#include <algorithm>
#include <filesystem>

#include "diagnostic_check.h"
#include "evaluate/programs/compile_errors.h"
#include "fuzz.h"
#include "lesson/read_lesson.h"
#include "require.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

void check_dependencies(const std::string& rule) {
  const std::vector<std::string> files = parse_dependencies(rule, "/course/work");
  require(std::is_sorted(files.begin(), files.end()), "files are sorted");
  require(std::adjacent_find(files.begin(), files.end()) == files.end(), "each file once");
  for (const fs::path file : files) {
    require(file.is_absolute() && file == file.lexically_normal(), "a path without detours");
    require(!file.string().starts_with("/course/work/"), "none of the folder's own");
  }
}

Compiled compiled_with(const std::string& said) {
  Compiled compiled;
  compiled.raw = said;
  compiled.messages = parse_messages(said);
  for (const CompilerMessage& message : compiled.messages) {
    require(message.line >= 0 && message.column >= 0, "a place is no negative one");
    require(said.find(message.text) != said.npos, "its words are the compiler's");
  }
  return compiled;
}

// Of a program in the lesson, and of one that stands in its own file alone.
void check_messages(const std::string& program, const std::string& said) {
  const std::string path = "content/1-a/1.1-x.md", name = "examples/x.cpp";
  const std::string bytes = "---\ntitle: T\n---\n````````cpp file=" + name + "\n" + program +
                            (program.ends_with('\n') ? "" : "\n") + "````````\n";
  Diagnostics diagnostics;
  const std::optional<Lesson> lesson = read_lesson(path, bytes, diagnostics);
  if (!lesson || lesson->blocks.size() != 1) return;
  const auto* example = std::get_if<Example>(&lesson->blocks[0]);
  if (example == nullptr) return;
  const Compiled compiled = compiled_with(said);
  const LocatedText alone{program, {}};
  for (const LocatedText* code : {&example->code, &alone}) {
    Diagnostics found;
    report_compile_messages(compiled, {*code, name, example->span}, *lesson, "/nowhere", found);
    check_diagnostics(found, {{path, SourceText(path, bytes)}, {name, SourceText(name, program)}});
    require(!found.empty(), "a program that was not compiled is a mistake");
  }
}

}  // namespace
}  // namespace mjcourse

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input = mjcourse::text_of_input(data, size), between = "=====\n";
  const std::size_t end = std::min(input.find(between), input.size());
  const std::string said = input.substr(std::min(end + between.size(), input.size()));
  mjcourse::check_dependencies(said);
  mjcourse::check_messages(input.substr(0, end), said);
  return 0;
}
