// The compiler's words, at the lines of the lesson that they are about.
#pragma once

#include <filesystem>
#include <string>

#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"
#include "toolchain/compiler.h"

namespace mjcourse {

// The text that was compiled: `code`, which stands from `first_line` on in the file that the
// compiler knows as `name`. `fence` is blamed for what has no line of its own.
struct CompiledText {
  const LocatedText& code;
  int first_line;
  std::string name;
  Span fence;
};

// Report the errors and warnings of `compiled`. Those in a header of the course, which lies at
// `root`, stand at the header's line.
void report_compile_messages(const Compiled& compiled, const CompiledText& text,
                             const Lesson& lesson, const std::filesystem::path& root,
                             Diagnostics& diagnostics);

}  // namespace mjcourse
