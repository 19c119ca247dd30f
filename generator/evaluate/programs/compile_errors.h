// The compiler's words, at the lines of the lesson that they are about.
#pragma once

#include <filesystem>
#include <string>

#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"
#include "toolchain/compiler.h"

namespace mjcourse {

// The text that was compiled: `code`, which the compiler knows as the file `name`. `fence` is
// blamed for what has no line of its own.
struct CompiledText {
  const LocatedText& code;
  std::string name;
  Span fence;
  // As which line of `name` the compiler counts the first of `code`.
  int first_line = 1;
};

// Report the errors and warnings of `compiled`. Those in a header of the course, which lies at
// `root`, stand at the header's line.
void report_compile_messages(const Compiled& compiled, const CompiledText& text,
                             const Lesson& lesson, const std::filesystem::path& root,
                             Diagnostics& diagnostics);

}  // namespace mjcourse
