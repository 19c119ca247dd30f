// What the commands have in common: read the course, evaluate it, tell what was found.
#pragma once

#include <filesystem>
#include <optional>

#include "cli/commands.h"
#include "evaluate/evaluate.h"

namespace mjcourse {

struct Verified {
  std::optional<Course> course;  // nothing when there is no readable course.yaml
  Evaluation evaluation;
  bool failed = false;
};

// The steps one by one, none of which prints: read the course, then evaluate it, if there is one.
Verified read_course_of(const Options& options);
void evaluate_course(const Options& options, Verified& verified);
// To stderr.
void print_diagnostics(const Diagnostics& diagnostics);

// All of it. Prints every diagnostic to stderr; a line for each lesson and a summary to stdout.
Verified verify_course(const Options& options);

// What the site's build made: the environment's MJCOURSE_ASSETS, else the folder that the build of
// this program filled.
std::filesystem::path assets_folder();

}  // namespace mjcourse
