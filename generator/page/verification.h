// What was verified, as the one JSON from which the verification page and the report are made;
// site/report/verification.ts has its shape.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "course/course.h"
#include "evaluate/evaluate.h"

namespace mjcourse {

// The file of it, beside the page.
inline constexpr const char* kVerificationPage = "verification.html";
inline constexpr const char* kVerificationJson = "verification.json";

// What a site publishes: the claims of every lesson but the drafts. The same for the same inputs.
nlohmann::json published_verification(const Course& course, const Evaluation& evaluation);

// What a report has: drafts too, the diagnostics, and measured times. `course` is null where there
// is no readable one.
nlohmann::json full_verification(const Course* course, const Evaluation& evaluation,
                                 double seconds);

// `json` as the text of a file.
std::string json_file(const nlohmann::json& json);

}  // namespace mjcourse
