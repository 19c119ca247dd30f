// `mjcourse grade DIR...`: hand-ins, judged side by side.
//
// Steps: find the hand-ins, and the exercises that were handed in; run their solutions; judge each
// text once, however many handed it in, and keep its verdict; write the tables.
// Tested by tests/system/grade_class.mjs.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "base/beneath.h"
#include "base/counted.h"
#include "base/nearest.h"
#include "base/out_folder.h"
#include "base/sha256.h"
#include "base/stopwatch.h"
#include "base/utf8.h"
#include "cli/commands.h"
#include "cli/exercise_list.h"
#include "cli/grades.h"
#include "cli/hand_ins.h"
#include "cli/kept_verdicts.h"
#include "cli/letter_names.h"
#include "cli/run.h"
#include "cli/settled_grades.h"
#include "cli/verify.h"
#include "evaluate/hand_in.h"
#include "lesson/syntax/exercise_text.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// How often somebody who reads a log is told how far it is.
constexpr double kTellSeconds = 15;

void note(const std::string& text) {
  std::cerr << "note: " << readable(text) << '\n';
}

// How far the work is, and how long it will take.
class GradeProgress {
 public:
  explicit GradeProgress(std::size_t all) : all_(all) {}
  ~GradeProgress() {
    if (is_terminal_) std::cerr << "\r\033[K" << std::flush;
  }
  GradeProgress(const GradeProgress&) = delete;
  GradeProgress& operator=(const GradeProgress&) = delete;

  // From any thread.
  void count() {
    const std::lock_guard lock(mutex_);
    ++done_;
    const double seconds = stopwatch_.seconds();
    if (!is_terminal_ && seconds < told_ + kTellSeconds) return;
    told_ = seconds;
    const double left = seconds / static_cast<double>(done_) * static_cast<double>(all_ - done_);
    const std::string text = std::to_string(done_) + " of " + counted(all_, "text") + " judged, " +
                             (left < 90 ? std::to_string(std::lround(left)) + " s"
                                        : std::to_string(std::lround(left / 60)) + " min") +
                             " to go";
    std::cerr << (is_terminal_ ? "\r" + text + "\033[K" : text + "\n") << std::flush;
  }

 private:
  const bool is_terminal_ = isatty(STDERR_FILENO) != 0;
  std::mutex mutex_;
  Stopwatch stopwatch_;
  std::size_t all_, done_ = 0;
  double told_ = 0;
};

struct Task {
  ListedExercise listed;
  JudgedExercise judged;
  std::string key;  // of what a verdict depends on beside the text
};

// One text, to be judged once.
struct Text {
  const Task* task;
  std::string code;
};

bool is_named(const GradeOptions& options, const ListedExercise& listed) {
  const std::vector<std::string>& names = options.exercises;
  return std::ranges::count(names, listed.name) + std::ranges::count(names, listed.lesson->number) >
         0;
}

// Those that are meant; where none is named, those that somebody handed in.
std::vector<ListedExercise> wanted(const GradeOptions& options, const Course& course,
                                   const HandIns& hand_ins) {
  std::vector<ListedExercise> all = exercises_of(course);
  std::erase_if(all, [&](const ListedExercise& listed) {
    if (!options.exercises.empty()) return !is_named(options, listed);
    return std::ranges::none_of(hand_ins.all, [&](const HandIn& hand_in) {
      return read_handed_in(hand_in, listed.name).is_there();
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
  if (options.hand_ins.empty()) {
    return Refusal{kWrongUsage, "which hand-ins?", "name their folders, one for each student"};
  }
  return std::nullopt;
}

// All that the verdict on a text depends on, beside the text.
std::string key_of(const JudgedExercise& judged, const std::string& seed, const fs::path& course) {
  const DiskFiles files(course);
  const Example& program = judged.exercise->program;
  const json options{seed, program.seconds, program.exit_code, program.optimize, program.arguments};
  std::string all = options.dump() + std::string(judged.files.text.file().text()) +
                    judged.files.hidden.value_or("") + judged.shown.key() + judged.hidden.key();
  for (const std::string& source : judged.sources) {
    all += source + sha256(files.read(source).value_or(""));
  }
  return sha256(all);
}

class Grading {
 public:
  Grading(const GradeOptions& options, const HandIns& hand_ins, const ExerciseJudge& judge,
          const KeptVerdicts& kept, std::vector<Task> tasks)
      : options_(options),
        hand_ins_(hand_ins),
        judge_(judge),
        kept_(kept),
        tasks_(std::move(tasks)) {}

  std::vector<GradedHandIn> run() {
    for (const HandIn& hand_in : hand_ins_.all) {
      GradedHandIn& graded = graded_.emplace_back(
          GradedHandIn{hand_in.student, hand_in.folder.string(), hand_in.fault, {}});
      for (const Task& task : tasks_) graded.grades.push_back(read(hand_in, task));
    }
    judge_texts();
    for (auto& [grade, key] : waiting_) {
      const Grade& made = made_.at(key);
      grade->checks = made.checks;
      grade->faults = made.faults;
      grade->is_hidden_fault = made.is_hidden_fault;
    }
    return std::move(graded_);
  }

 private:
  Grade read(const HandIn& hand_in, const Task& task) {
    const HandedIn found = read_handed_in(hand_in, task.listed.name);
    const std::string name = task.listed.name + ".cpp";
    Verdict verdict = nothing_made(task.judged);
    const auto refuse = [&](const std::string& why) {
      Place place;
      place.file = name;
      verdict.faults.push_back(error_at(std::move(place), "E-hand-in", why));
    };
    const std::string& region = task.judged.exercise->program.region->text;
    std::optional<std::string> code;
    if (!found.fault.empty()) refuse(found.fault);
    if (found.text) {
      if (auto inside = code_in_region(*found.text, region)) {
        code = *std::move(inside);
      } else {
        refuse("it " + inside.error());
      }
    }
    Grade grade = grade_of(task.judged, task.listed.title, verdict);
    grade.handed_in = found.is_there();
    if (options_.due && found.changed && *found.changed > *options_.due) {
      const auto late = std::chrono::ceil<std::chrono::minutes>(*found.changed - *options_.due);
      grade.minutes_late = late.count();
    }
    if (code) {
      const std::string key = sha256(task.key + *code);
      texts_.emplace(key, Text{&task, *code});
      keys_.push_back(key);
    } else {
      keys_.emplace_back();
    }
    return grade;
  }

  void judge_texts() {
    std::size_t next = 0;
    for (GradedHandIn& hand_in : graded_) {
      for (Grade& grade : hand_in.grades) {
        if (const std::string& key = keys_[next++]; !key.empty())
          waiting_.emplace_back(&grade, key);
      }
    }
    std::vector<std::string> left;
    for (const auto& [key, text] : texts_) {
      auto known = kept_.find(key, grade_of(text.task->judged, text.task->listed.title,
                                            nothing_made(text.task->judged)));
      if (known) made_[key] = *std::move(known);
      if (!made_.contains(key)) left.push_back(key);
    }
    if (left.size() < texts_.size()) {
      note(counted(texts_.size() - left.size(), "verdict") + " of an earlier run " +
           (texts_.size() - left.size() == 1 ? "is" : "are") + " taken up again");
    }
    judge_each(left);
  }

  void judge_each(const std::vector<std::string>& keys) {
    std::optional<GradeProgress> progress(keys.size());
    GradeWork work;
    work.judge = [&](std::size_t i) {
      const Text& text = texts_.at(keys[i]);
      const Task& task = *text.task;
      return grade_of(task.judged, task.listed.title,
                      judge_.judge(task.judged, text.code, task.listed.name + ".cpp", true));
    };
    work.done = [&](std::size_t i, const Grade& grade) {
      kept_.keep(keys[i], grade);
      progress->count();
    };
    work.again = [&](std::size_t texts) {
      progress.reset();
      note(counted(texts, "text") + " may have been short of time or memory, and " +
           (texts == 1 ? "is" : "are each") + " judged once more, alone");
      progress.emplace(texts);
    };
    const std::vector<Grade> grades = settled_grades(keys.size(), options_.jobs, work);
    for (std::size_t i = 0; i < keys.size(); ++i) made_[keys[i]] = grades[i];
  }

  const GradeOptions& options_;
  const HandIns& hand_ins_;
  const ExerciseJudge& judge_;
  const KeptVerdicts& kept_;
  std::vector<Task> tasks_;
  std::vector<GradedHandIn> graded_;
  std::vector<std::string> keys_;  // of each grade, in their order
  std::map<std::string, Text> texts_;
  std::map<std::string, Grade> made_;
  std::vector<std::pair<Grade*, std::string>> waiting_;
};

void write_all(const OutFolder& folder, const std::vector<GradedHandIn>& graded) {
  folder.write("students.csv", students_csv(graded));
  folder.write("checks.csv", grades_text(graded, GradeFormat::csv));
  folder.write("grades.json", grades_text(graded, GradeFormat::json));
  std::vector<std::string> students;
  for (const GradedHandIn& hand_in : graded) students.push_back(hand_in.student);
  const std::vector<std::string> names = letter_names(students);
  for (std::size_t i = 0; i < graded.size(); ++i)
    folder.write("letters/" + names[i], letter(graded[i]));
  note("tables, and a letter for each student, are in " + folder.path().string());
}

int grade_all(const GradeOptions& options, const Verified& verified, const HandIns& hand_ins,
              const KeptVerdicts& kept) {
  const Course& course = *verified.course;
  JudgeKey key = JudgeKey::random();
  if (!options.seed.empty()) key.seed = options.seed;
  key.seed = kept.seed(key.seed, !options.seed.empty());
  const DiskFiles assets(assets_folder());
  const ExerciseJudge judge(course, evaluation_settings(options, assets, verified.store.get()),
                            key);
  Diagnostics diagnostics;
  if (auto why = judge.why_nothing_runs()) diagnostics.push_back(*std::move(why));
  std::vector<Task> tasks;
  for (const ListedExercise& listed : wanted(options, course, hand_ins)) {
    auto judged = diagnostics.empty() ? judge.prepare(*listed.lesson, *listed.exercise,
                                                      hand_ins.all.size(), diagnostics)
                                      : std::nullopt;
    if (!judged) continue;
    tasks.push_back({listed, *std::move(judged), ""});
    tasks.back().key = key_of(tasks.back().judged, key.seed, options.course);
  }
  if (!diagnostics.empty()) {
    print_diagnostics(diagnostics);
    return kCourseErrors;
  }
  std::vector<std::string> names;
  for (const ListedExercise& listed : exercises_of(course)) {
    if (options.exercises.empty() || is_named(options, listed)) names.push_back(listed.name);
  }
  for (const std::string& one : hand_ins.notes) note(one);
  for (const HandIn& hand_in : hand_ins.all) {
    for (const std::string& one : notes_on(hand_in, names)) note(one);
  }
  if (tasks.empty()) {
    return tell(Refusal{kWrongUsage, "nothing was handed in here",
                        "name the folder of each student, with NAME.cpp or NAME/NAME.cpp of an "
                        "exercise of the course"});
  }
  const std::vector<GradedHandIn> graded =
      Grading(options, hand_ins, judge, kept, std::move(tasks)).run();
  if (kept.folder()) write_all(*kept.folder(), graded);
  std::cout << grades_text(graded, options.format);
  note("the inputs of checks were drawn from --seed " + key.seed);
  return kClean;
}

}  // namespace

int grade(const GradeOptions& options) {
  const Verified verified = read_course_of(options);
  if (!verified.course) {
    print_diagnostics(verified.evaluation.diagnostics);
    return kCourseErrors;
  }
  if (const auto refused = unknown(options, *verified.course)) return tell(*refused);
  const HandIns hand_ins = find_hand_ins(options.hand_ins);
  try {
    return grade_all(options, verified, hand_ins, KeptVerdicts(options.results, options.course));
  } catch (const RefusedPath& refused) {
    return tell({kCourseErrors, refused.what(), "remove it, or name another folder: `--out DIR`"});
  }
}

}  // namespace mjcourse
