#include "cli/verify.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <tuple>
#include <vector>

#include "cli/progress_bar.h"
#include "report/terminal.h"

namespace mjcourse {
namespace {

// "3 programs run", "1 lab rehearsed"; "" for none.
void add_count(std::vector<std::string>& parts, int count, const char* one, const char* many) {
  if (count > 0) parts.push_back(std::to_string(count) + " " + (count == 1 ? one : many));
}

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
  return text.empty() ? "nothing to verify" : text;
}

std::string counted(std::ptrdiff_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

// In the order of the files and of their lines, whichever thread came first.
void sort_diagnostics(Diagnostics& diagnostics) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [](const Diagnostic& a, const Diagnostic& b) {
                     return std::tie(a.place.file, a.place.line, a.place.column) <
                            std::tie(b.place.file, b.place.line, b.place.column);
                   });
}

void print_diagnostics(const Diagnostics& diagnostics) {
  TerminalStyle style;
  style.colours = isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
  for (const Diagnostic& diagnostic : diagnostics) {
    std::cerr << format_for_terminal(diagnostic, style) << '\n';
  }
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
              << tally_text(evaluation.lessons[i].tally);
    if (lesson.front.draft) std::cout << "; a draft, not in the site";
    if (errors > 0) std::cout << "; " << counted(errors, "error");
    std::cout << '\n';
  }
}

}  // namespace

std::filesystem::path assets_folder() {
  const char* named = std::getenv("MJCOURSE_ASSETS");
  return named != nullptr ? named : MJCOURSE_DEFAULT_ASSETS;
}

Verified verify_course(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  Verified verified;
  Diagnostics reading;
  verified.course = read_course(DiskFiles(options.course), reading);
  if (verified.course) {
    ProgressBar progress;
    verified.evaluation =
        evaluate(*verified.course, options.course, DiskFiles(assets_folder()), progress);
  }
  Diagnostics& all = verified.evaluation.diagnostics;
  all.insert(all.begin(), reading.begin(), reading.end());
  sort_diagnostics(all);
  print_diagnostics(all);

  Tally total;
  if (verified.course) print_lessons(*verified.course, verified.evaluation);
  for (const LessonResults& lesson : verified.evaluation.lessons) total += lesson.tally;
  const std::ptrdiff_t errors = errors_in(all, "");
  verified.failed = errors > 0;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  char time[32];
  std::snprintf(time, sizeof time, "%.1f s", seconds.count());
  std::cout << (verified.course
                    ? counted(static_cast<std::ptrdiff_t>(verified.course->lessons.size()),
                              "lesson") +
                          ": " + tally_text(total) + "; "
                    : "")
            << counted(errors, "error") << ", " << time << '\n';
  return verified;
}

}  // namespace mjcourse
