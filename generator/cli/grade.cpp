// `mjcourse grade DIR...`: hand-ins, judged side by side.
//
// Steps: find the exercises that were handed in; run their solutions; judge each text of each
// hand-in, of which nothing but its regions is read; tell what came of them.
// Tested by tests/system/grade.mjs.
#include <algorithm>
#include <iostream>
#include <set>
#include <string>
#include <utility>

#include "base/nearest.h"
#include "base/parallel.h"
#include "cli/commands.h"
#include "cli/grades.h"
#include "cli/run.h"
#include "cli/verify.h"
#include "evaluate/hand_in.h"
#include "lesson/syntax/exercise_text.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = 1 << 20;  // of a program that was handed in

// The text of the exercise in the hand-in `folder`; nothing where it was not handed in, or why it
// is not read.
struct HandedIn {
  std::optional<std::string> text;
  std::string fault;
};

HandedIn handed_in(const fs::path& folder, const std::string& name) {
  const DiskFiles files(folder);
  for (const std::string& path : {name + ".cpp", name + "/" + name + ".cpp"}) {
    if (const auto refusal = files.refusal(path)) return {std::nullopt, "it is no plain file"};
    if (!files.exists(path)) continue;
    std::error_code none;
    if (fs::file_size(folder / path, none) > kMostBytes || none) {
      return {std::nullopt, "it has more than 1 MiB"};
    }
    auto text = files.read(path);
    if (!text) return {std::nullopt, "it cannot be read"};
    return {*std::move(text), ""};
  }
  return {};
}

bool is_named(const GradeOptions& options, const ListedExercise& listed) {
  const std::vector<std::string>& names = options.exercises;
  return std::ranges::count(names, listed.name) + std::ranges::count(names, listed.lesson->number) >
         0;
}

// Those that are meant; where none is named, those that somebody handed in.
std::vector<ListedExercise> wanted(const GradeOptions& options, const Course& course) {
  std::vector<ListedExercise> all = exercises_of(course);
  std::erase_if(all, [&](const ListedExercise& listed) {
    if (!options.exercises.empty()) return !is_named(options, listed);
    return std::ranges::none_of(options.hand_ins, [&](const std::string& folder) {
      const HandedIn found = handed_in(folder, listed.name);
      return found.text || !found.fault.empty();
    });
  });
  return all;
}

// A name that is none.
std::optional<Refusal> unknown(const GradeOptions& options, const Course& course) {
  std::vector<std::string> known;
  for (const ListedExercise& listed : exercises_of(course)) {
    known.push_back(listed.name);
    known.push_back(listed.lesson->number);
  }
  for (const std::string& name : options.exercises) {
    if (std::ranges::count(known, name) > 0) continue;
    return Refusal{kWrongUsage, "the course has no exercise " + name, suggest(name, known)};
  }
  for (const std::string& folder : options.hand_ins) {
    if (fs::is_directory(folder)) continue;
    return Refusal{kWrongUsage, "there is no folder " + folder, "name the folders of the hand-ins"};
  }
  if (options.hand_ins.empty()) {
    return Refusal{kWrongUsage, "which hand-ins?", "name their folders, one for each"};
  }
  return std::nullopt;
}

Grade grade_of(const std::string& folder, const JudgedExercise& exercise,
               const ExerciseJudge& judge) {
  const std::string name = exercise.exercise->program.name();
  const HandedIn found = handed_in(folder, name);
  Grade grade{name, exercise.lesson->number, found.text || !found.fault.empty(),
              nothing_made(exercise), points_of(exercise.shown) + points_of(exercise.hidden)};
  const auto refuse = [&](const std::string& why) {
    Place place;
    place.file = name + ".cpp";
    grade.verdict.faults.push_back(error_at(std::move(place), "E-hand-in", why));
    return grade;
  };
  if (!found.fault.empty()) return refuse(found.fault);
  if (!found.text) return grade;
  const std::string& region = exercise.exercise->program.region->text;
  const auto code = code_in_region(*found.text, region);
  if (!code) return refuse("it has no region `" + region + "`");
  grade.verdict = judge.judge(exercise, *code, name + ".cpp", true);
  return grade;
}

}  // namespace

int grade(const GradeOptions& options) {
  const Verified verified = read_course_of(options);
  Diagnostics diagnostics = verified.evaluation.diagnostics;
  if (!verified.course) {
    print_diagnostics(diagnostics);
    return kCourseErrors;
  }
  const Course& course = *verified.course;
  if (const auto refused = unknown(options, course)) return tell(*refused);
  const DiskFiles assets(assets_folder());
  const ExerciseJudge judge(course, evaluation_settings(options, assets, verified.store.get()));
  diagnostics.clear();  // of lessons that are none of these
  if (auto why = judge.why_nothing_runs()) diagnostics.push_back(*std::move(why));
  std::vector<JudgedExercise> exercises;
  for (const ListedExercise& listed : wanted(options, course)) {
    auto judged = diagnostics.empty() ? judge.prepare(*listed.lesson, *listed.exercise, diagnostics)
                                      : std::nullopt;
    if (judged) exercises.push_back(*std::move(judged));
  }
  if (!diagnostics.empty()) {
    print_diagnostics(diagnostics);
    return kCourseErrors;
  }
  if (exercises.empty()) {
    return tell(Refusal{kWrongUsage, "nothing was handed in here",
                        "name the folder of each hand-in, with NAME.cpp or NAME/NAME.cpp of an "
                        "exercise of the course"});
  }
  std::vector<GradedHandIn> graded;
  for (const std::string& folder : options.hand_ins) {
    graded.push_back({folder, std::vector<Grade>(exercises.size())});
  }
  for_each_index(graded.size() * exercises.size(), options.jobs, [&](std::size_t i, std::size_t) {
    const std::size_t exercise = i % exercises.size();
    GradedHandIn& hand_in = graded[i / exercises.size()];
    hand_in.grades[exercise] = grade_of(hand_in.folder, exercises[exercise], judge);
  });
  std::cout << grades_text(graded, options.format);
  return kClean;
}

}  // namespace mjcourse
