// The text of a snippet as a program of its own, which a reader edits and takes along.
//
// The snippet stays the body of a function: so it may return, and what it declares meets nothing of
// main().
// Tested by tests/generator/evaluate/programs/snippets_test.cpp.
#pragma once

#include <string>

#include "lesson/blocks/block.h"

namespace mjcourse {

// `prelude` is what it includes (snippets.h).
std::string snippet_text(const Snippet& snippet, const std::string& prelude);

}  // namespace mjcourse
