// The code of an example, which its fence and its file in examples/ hold both.
// Tested by tests/generator/evaluate/programs/example_test.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "evaluate/context/shown_program.h"
#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// What is compiled, and the diagnostic that says that its file is another text.
struct ExampleCode {
  LocatedText text;
  std::optional<std::size_t> differs;
};

// The code of an example: its fence's, or the file's where the fence is empty. Both must agree, but
// for how their lines end.
std::optional<ExampleCode> code_of(const Example& example, const ShownProgram& shown,
                                   const Lesson& lesson,
                                   const tl::expected<std::string, std::string>& file,
                                   Diagnostics& diagnostics);

// The program is as it should be, so its file can be written from the fence: `differs`, which says
// that they differ, gets the edit.
void offer_file(const Example& example, const ShownProgram& shown, const Lesson& lesson,
                const tl::expected<std::string, std::string>& file, Diagnostic& differs);

}  // namespace mjcourse
