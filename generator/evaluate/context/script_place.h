// The place in a lesson of a mistake in one of its scripts.
// Tested by tests/generator/evaluate/answers/inline_value_test.cpp.
#pragma once

#include "lesson/syntax/located_text.h"
#include "report/diagnostic.h"
#include "script/script_error.h"

namespace mjcourse {

// `script` is the text that `error` counts its lines in.
Diagnostic script_diagnostic(const ScriptError& error, const LocatedText& script,
                             const SourceText& lesson);

}  // namespace mjcourse
