// What the formats for other tools have in common.
// Tested by tests/generator/report/github_test.cpp.
#pragma once

#include <string>

#include "report/diagnostic.h"

namespace mjcourse {

// A file of a course as a tool finds it that knows where the course lies: "docs/" + "content/…".
std::string course_path(const std::string& folder, const std::string& file);

// The message, then its details and what to do about it on lines of their own.
std::string message_with_cure(const Diagnostic& diagnostic);

}  // namespace mjcourse
