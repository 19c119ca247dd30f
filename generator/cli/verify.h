// What the commands have in common: read the course, evaluate it, tell what was found.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "cli/commands.h"
#include "cli/open_store.h"
#include "evaluate/evaluate.h"

namespace mjcourse {

struct Verified {
  std::optional<Course> course;  // nothing when there is no readable course.yaml
  OpenedStore store;             // which has the pictures of the evaluation
  Evaluation evaluation;
  bool failed = false;
  double seconds = 0;  // measured
};

// The steps one by one, none of which prints diagnostics: read the course, then evaluate it, if
// there is one.
Verified read_course_of(const CourseOptions& options);
// `all_claims`: also those of lessons that state nothing but what nobody runs. Where what programs
// are in the page takes much work, `show` gets the evaluation without that, before the work.
using ShowNative = std::function<void(Course& course, const Evaluation& evaluation)>;
void evaluate_course(const CourseOptions& options, Verified& verified, bool all_claims,
                     const Shard& shard = {}, const ShowNative& show = {});
std::ptrdiff_t count_errors(const Diagnostics& diagnostics);
// To stderr.
void print_diagnostics(const Diagnostics& diagnostics);

// All of it. Prints every diagnostic to stderr; a line for each lesson and a summary to stdout, or
// to stderr too where stdout is for another format.
Verified verify_course(const VerifyOptions& options, const ShowNative& show = {});

// What the generator needs beside itself, made by the build: scripts and templates of the site,
// skeletons, the helper header. The environment's MJCOURSE_ASSETS, else as seen from this program's
// own place: in a build tree `../assets`, where it is installed `../share/mjcourse`.
std::filesystem::path assets_folder();

// The generator's own file.
std::filesystem::path own_program();

// Of a course, for evaluating it; `store` may be null.
EvaluationSettings evaluation_settings(const CourseOptions& options, const Files& assets,
                                       Store* store);

}  // namespace mjcourse
