#include "cli/verify.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "base/stopwatch.h"
#include "cli/progress_bar.h"
#include "evaluate/strict.h"
#include "page/report.h"
#include "report/terminal.h"

namespace mjcourse {
namespace {

// "3 programs run", "1 lab rehearsed"; "" for none.
void add_count(std::vector<std::string>& parts, int count, const char* one, const char* many) {
  if (count > 0) parts.push_back(counted(count, one, many));
}

// "" where nothing was verified.
std::string tally_text(const Tally& tally) {
  std::vector<std::string> parts;
  add_count(parts, tally.programs, "program run", "programs run");
  add_count(parts, tally.snippets, "snippet run", "snippets run");
  add_count(parts, tally.outputs, "output compared", "outputs compared");
  add_count(parts, tally.values, "value computed", "values computed");
  add_count(parts, tally.listed_models, "model listing checked", "model listings checked");
  add_count(parts, tally.answers_proved, "answer proved", "answers proved");
  add_count(parts, tally.answers_asserted, "answer asserted", "answers asserted");
  add_count(parts, tally.labs, "lab rehearsed", "labs rehearsed");
  add_count(parts, tally.pictures, "picture drawn", "pictures drawn");
  add_count(parts, tally.plots, "plot drawn", "plots drawn");
  add_count(parts, tally.formulas, "formula set", "formulas set");
  add_count(parts, tally.unchecked, "listing unchecked", "listings unchecked");
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

// The same for a reader who must not take a failure for a lesson of prose.
std::string outcome_text(const Tally& tally, std::ptrdiff_t errors) {
  std::string text = tally_text(tally);
  if (!text.empty()) return text;
  return errors > 0 ? "nothing verified" : "nothing to verify";
}

// In the order of the files and of their lines, whichever thread came first.
void sort_diagnostics(Diagnostics& diagnostics) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [](const Diagnostic& a, const Diagnostic& b) {
                     return std::tie(a.place.file, a.place.line, a.place.column) <
                            std::tie(b.place.file, b.place.line, b.place.column);
                   });
}

// Adds what only --strict minds; what is a warning without it is an error.
void apply_strictly(Evaluation& evaluation) {
  Diagnostics& all = evaluation.diagnostics;
  const auto add = [&](const LessonResults& page) {
    const Diagnostics found = unreasoned(page.claims);
    all.insert(all.end(), found.begin(), found.end());
  };
  for (const LessonResults& lesson : evaluation.lessons) add(lesson);
  add(evaluation.glossary);
  for (Diagnostic& diagnostic : all) diagnostic.severity = Severity::error;
}

// Errors in `file`, and those elsewhere that a note says it has a part in: a model that it uses.
bool concerns(const Diagnostic& diagnostic, const std::string& file) {
  return diagnostic.place.file == file ||
         std::any_of(diagnostic.notes.begin(), diagnostic.notes.end(),
                     [&](const Note& note) { return note.place.file == file; });
}

std::ptrdiff_t errors_in(const Diagnostics& diagnostics, const std::string& file) {
  return std::count_if(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& d) {
    return d.severity == Severity::error && (file.empty() || concerns(d, file));
  });
}

void print_lessons(const Course& course, const Evaluation& evaluation) {
  for (std::size_t i = 0; i < course.lessons.size(); ++i) {
    const Lesson& lesson = course.lessons[i];
    const std::ptrdiff_t errors = errors_in(evaluation.diagnostics, lesson.source->path());
    const std::string& title = lesson.front.title.text;
    std::cout << (errors == 0 ? "ok    " : "FAIL  ") << lesson.number << "  "
              << (title.empty() ? lesson.slug : title) << ": "
              << outcome_text(evaluation.lessons[i].tally, errors);
    if (lesson.front.draft) std::cout << "; a draft, not in the site";
    if (errors > 0) std::cout << "; " << counted(errors, "error");
    std::cout << '\n';
  }
}

void print_glossary(const Glossary& glossary, const Evaluation& evaluation) {
  const std::ptrdiff_t errors = errors_in(evaluation.diagnostics, kGlossaryPath);
  std::cout << (errors == 0 ? "ok    " : "FAIL  ")
            << "glossary: " << counted(glossary.terms.size(), "term");
  const std::string verified = tally_text(evaluation.glossary.tally);
  if (!verified.empty()) std::cout << ", " << verified;
  if (errors > 0) std::cout << "; " << counted(errors, "error");
  std::cout << '\n';
}

}  // namespace

std::filesystem::path assets_folder() {
  const char* named = std::getenv("MJCOURSE_ASSETS");
  return named != nullptr ? named : MJCOURSE_DEFAULT_ASSETS;
}

void print_diagnostics(const Diagnostics& diagnostics) {
  TerminalStyle style;
  style.colours = isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
  for (const Diagnostic& diagnostic : diagnostics) {
    std::cerr << format_for_terminal(diagnostic, style) << '\n';
  }
}

Verified read_course_of(const Options& options) {
  Verified verified;
  verified.course = read_course(DiskFiles(options.course), verified.evaluation.diagnostics);
  return verified;
}

void evaluate_course(const Options& options, Verified& verified) {
  Diagnostics reading = std::move(verified.evaluation.diagnostics);
  if (verified.course) {
    ProgressBar progress;
    verified.evaluation = evaluate(*verified.course, options.course, DiskFiles(assets_folder()),
                                   progress, std::move(reading));
  } else {
    verified.evaluation.diagnostics = std::move(reading);
    verified.evaluation.versions = known_versions(DiskFiles(assets_folder()));
  }
  if (options.strict) apply_strictly(verified.evaluation);
  sort_diagnostics(verified.evaluation.diagnostics);
}

Verified verify_course(const Options& options) {
  const Stopwatch stopwatch;
  Verified verified = read_course_of(options);
  evaluate_course(options, verified);
  const Diagnostics& all = verified.evaluation.diagnostics;
  print_diagnostics(all);

  Tally total;
  if (verified.course) print_lessons(*verified.course, verified.evaluation);
  if (verified.course && verified.course->glossary) {
    print_glossary(*verified.course->glossary, verified.evaluation);
  }
  for (const LessonResults& lesson : verified.evaluation.lessons) total += lesson.tally;
  total += verified.evaluation.glossary.tally;
  const std::ptrdiff_t errors = errors_in(all, "");
  verified.failed = errors > 0;
  const double seconds = stopwatch.seconds();
  char time[32];
  std::snprintf(time, sizeof time, "%.1f s", seconds);
  std::cout << (verified.course ? counted(verified.course->lessons.size(), "lesson") + ": " +
                                      outcome_text(total, errors) + "; "
                                : "")
            << counted(errors, "error") << ", " << time << '\n';
  if (!options.report.empty()) {
    write_report({verified.course ? &*verified.course : nullptr, verified.evaluation, seconds},
                 assets_folder(), options.report);
    std::cout << "report: " << options.report.lexically_normal().string() << "/index.html\n";
  }
  return verified;
}

}  // namespace mjcourse
