// What the formats for other tools have in common.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "report/diagnostic.h"

namespace mjcourse {

// A file of a course as those find it who know where the course lies: "docs/" + "content/…".
std::string course_path(const std::string& folder, const std::string& file);

// `text` with each byte that is not `plain` as a percent sign and its number: "%0A".
std::string percent_encoded(std::string_view text, const std::function<bool(char)>& plain);

// The message, then its details and what to do about it on lines of their own.
std::string message_with_cure(const Diagnostic& diagnostic);

}  // namespace mjcourse
