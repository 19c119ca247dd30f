// What was verified, as the one JSON from which the verification page and the report are made;
// site/browser/report/verification.ts has its shape.
// Tested by tests/generator/page/verification_page_test.cpp.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "course/course.h"
#include "findings/evaluation.h"

namespace mjcourse {

// What a site publishes: the claims of every lesson but the drafts. The same for the same inputs.
nlohmann::json published_verification(const Course& course, const Evaluation& evaluation);

// The parts from which that can be put together: all but the lessons, with the counts of all of
// them; and one lesson.
nlohmann::json verification_of_none(const std::string& course, const Versions& versions);
nlohmann::json verification_of(const Lesson& lesson, const Claims& claims);
// How many claims came to each Claim::Status.
using StatusCounts = std::array<int, 5>;
StatusCounts counts_of(const Claims& claims);
void add_counts(nlohmann::json& counts, const StatusCounts& more);

// What a report has: drafts too, the diagnostics, and measured times. `course` is null where there
// is no readable one.
nlohmann::json full_verification(const Course* course, const Evaluation& evaluation,
                                 double seconds);

// A value inside such a file, where it stands `columns` to the right.
std::string json_text(const nlohmann::json& json);
std::string indented(const std::string& text, std::size_t columns);

// `json` as the text of a file.
std::string json_file(const nlohmann::json& json);

}  // namespace mjcourse
