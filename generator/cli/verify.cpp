#include "cli/verify.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <utility>

#include "base/counted.h"
#include "base/out_folder.h"
#include "base/stopwatch.h"
#include "base/store_layout.h"
#include "base/utf8.h"
#include "cli/progress_bar.h"
#include "cli/tally_text.h"
#include "cli/timings.h"
#include "evaluate/claims/claims.h"
#include "evaluate/claims/strict.h"
#include "evaluate/versions.h"
#include "page/report.h"
#include "process/sandbox.h"
#include "report/terminal.h"
#include "session/examine.h"

namespace mjcourse {
namespace {

// Tasks of programs in the page, of a second or two each: nobody wants to wait for more.
constexpr std::size_t kMuch = 10;

// Adds what only --strict minds; what is a warning without it is an error.
void apply_strictly(Verified& verified) {
  Evaluation& evaluation = verified.evaluation;
  Diagnostics& all = evaluation.diagnostics;
  const auto pages = verified.course ? verified.course->pages() : std::vector<const Lesson*>();
  for (const Lesson* page : pages) {
    const LessonResults& results = evaluation.results_of(*page);
    const Diagnostics found = unreasoned(results.claims);
    all.insert(all.end(), found.begin(), found.end());
  }
  for (Diagnostic& diagnostic : all) diagnostic.severity = Severity::error;
  sort_by_place(all);
}

// Those that concern `file`; all where that is "".
std::ptrdiff_t errors_in(const Diagnostics& diagnostics, const std::string& file) {
  return std::count_if(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& d) {
    return d.severity == Severity::error && (file.empty() || concerns(d, file));
  });
}

void print_lessons(const Course& course, const Evaluation& evaluation, std::ostream& out) {
  for (std::size_t i = 0; i < course.lessons.size(); ++i) {
    const Lesson& lesson = course.lessons[i];
    const std::ptrdiff_t errors = errors_in(evaluation.diagnostics, lesson.source->path());
    // Other shards tell of it.
    if (evaluation.open && errors == 0 && tally_text(evaluation.lessons[i].tally).empty()) continue;
    const std::string& title = lesson.front.title.text;
    out << (errors == 0 ? "ok    " : "FAIL  ") << lesson.number << "  "
        << readable(title.empty() ? lesson.slug : title) << ": "
        << outcome_text(evaluation.lessons[i].tally, errors);
    if (lesson.front.draft) out << "; a draft, not in the site";
    if (errors > 0) out << "; " << counted(errors, "error");
    out << '\n';
  }
}

void print_glossary(const Glossary& glossary, const Evaluation& evaluation, std::ostream& out) {
  const std::ptrdiff_t errors = errors_in(evaluation.diagnostics, kGlossaryPath);
  out << (errors == 0 ? "ok    " : "FAIL  ")
      << "glossary: " << counted(glossary.terms.size(), "term");
  const std::string verified = tally_text(evaluation.glossary.tally);
  if (!verified.empty()) out << ", " << verified;
  if (errors > 0) out << "; " << counted(errors, "error");
  out << '\n';
}

}  // namespace

std::filesystem::path assets_folder() {
  if (const char* named = std::getenv("MJCOURSE_ASSETS")) return named;
  std::error_code none;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", none);
  const std::filesystem::path prefix = program.parent_path().parent_path();
  const std::filesystem::path built = prefix / "assets";
  return std::filesystem::exists(built / "manifest.json") ? built : prefix / "share" / "mjcourse";
}

std::filesystem::path own_program() {
  return std::filesystem::read_symlink("/proc/self/exe");
}

EvaluationSettings evaluation_settings(const CourseOptions& options, const Files& assets,
                                       Store* store) {
  EvaluationSettings settings{options.course, assets, store, options.jobs,
                              assets_folder() / "examples" / "include"};
  settings.without_landlock = options.without_landlock;
  settings.worker = {own_program(), std::filesystem::absolute(assets_folder())};
  settings.page = assets_folder() / "cpp";
  const std::filesystem::path folder = store_folder(options.store);
  if (store != nullptr && !folder.empty()) settings.prepared = prepared_folder(folder);
  return settings;
}

void print_diagnostics(const Diagnostics& diagnostics) {
  std::cerr << format_for_terminal(diagnostics, style_for(STDERR_FILENO));
}

std::ptrdiff_t count_errors(const Diagnostics& diagnostics) {
  return errors_in(diagnostics, "");
}

Verified read_course_of(const CourseOptions& options) {
  Verified verified;
  verified.store = open_store(options.store, options.shared);
  verified.course =
      read_course(DiskFiles(options.course), verified.evaluation.diagnostics, options.jobs);
  return verified;
}

namespace {

Evaluation examined(const Course& course, const EvaluationSettings& settings,
                    const Diagnostics& reading) {
  ProgressBar progress;
  return examine(course, settings, progress, reading);
}

// The tasks of `times`, of which some were worked on `earlier`: before `seconds` had passed.
void add_earlier(const std::vector<TaskTime>& earlier, double seconds,
                 std::vector<TaskTime>& times) {
  std::multimap<std::string, const TaskTime*> worked;
  for (const TaskTime& time : earlier) {
    if (!time.reused) worked.emplace(time.what, &time);
  }
  for (TaskTime& time : times) {
    time.begin += seconds;
    const auto known = worked.find(time.what);
    if (!time.reused || known == worked.end()) continue;
    time = *known->second;
    worked.erase(known);
  }
  for (const auto& [what, time] : worked) times.push_back(*time);  // headers, which are made once
}

}  // namespace

void evaluate_course(const CourseOptions& options, Verified& verified, bool all_claims,
                     const Shard& shard, const ShowNative& show) {
  Diagnostics reading = std::move(verified.evaluation.diagnostics);
  if (verified.course) {
    const DiskFiles assets(assets_folder());
    Store* store = verified.store.get();
    EvaluationSettings settings = evaluation_settings(options, assets, store);
    settings.shard = shard;
    settings.notes_times = shard.is_whole();
    if (store != nullptr) settings.fingerprint_cache->read(*store, options.course);
    const bool is_shown = show && store != nullptr;  // which has it a moment later
    settings.natively = is_shown;
    const Stopwatch stopwatch;
    verified.evaluation = examined(*verified.course, settings, reading);
    if (is_shown && verified.evaluation.open) {
      if (verified.evaluation.open_in_page >= kMuch &&
          count_errors(verified.evaluation.diagnostics) == 0) {
        show(*verified.course, verified.evaluation);
      }
      settings.natively = false;
      const double seconds = stopwatch.seconds();
      Evaluation whole = examined(*verified.course, settings, reading);
      add_earlier(verified.evaluation.times, seconds, whole.times);
      verified.evaluation = std::move(whole);
    }
    if (store != nullptr) settings.fingerprint_cache->write(*store, options.course);
  } else {
    verified.evaluation.diagnostics = std::move(reading);
    verified.evaluation.versions = known_versions(DiskFiles(assets_folder()));
  }
  if (verified.course && all_claims && shard.is_first()) {
    claim_prose(*verified.course, DiskFiles(options.course), verified.evaluation);
  }
  sort_by_place(verified.evaluation.diagnostics);
}

Verified verify_course(const VerifyOptions& options, const ShowNative& show) {
  const Stopwatch stopwatch;
  Verified verified = read_course_of(options);
  // These need every claim of every lesson.
  const bool all_claims = options.strict || !options.report.empty() ||
                          options.format == Format::json || options.format == Format::junit;
  evaluate_course(options, verified, all_claims, options.shard, show);
  if (options.strict) apply_strictly(verified);
  const Diagnostics& all = verified.evaluation.diagnostics;
  print_diagnostics(all);

  std::ostream& out = options.format == Format::text ? std::cout : std::cerr;
  Tally total;
  if (verified.course) print_lessons(*verified.course, verified.evaluation, out);
  if (verified.course && verified.course->glossary && options.shard.is_first()) {
    print_glossary(*verified.course->glossary, verified.evaluation, out);
  }
  for (const LessonResults& lesson : verified.evaluation.lessons) total += lesson.tally;
  total += verified.evaluation.glossary.tally;
  const std::ptrdiff_t errors = count_errors(all);
  verified.failed = errors > 0;
  verified.seconds = stopwatch.seconds();
  char time[32];
  std::snprintf(time, sizeof time, "%.1f s", verified.seconds);
  if (!options.shard.is_whole() && verified.course) {
    out << "shard " << options.shard.number << " of " << options.shard.count << ": "
        << verified.evaluation.tasks << " of " << counted(verified.evaluation.all_tasks, "task")
        << ", by division " << verified.evaluation.division << '\n';
  }
  out << (verified.course ? counted(verified.course->lessons.size(), "lesson") + ": " +
                                outcome_text(total, errors) + "; "
                          : "")
      << counted(errors, "error") << ", " << time << '\n';
  const std::string& sandbox = verified.evaluation.sandbox;
  if (!sandbox.empty()) out << "sandbox: " << sandbox << '\n';
  const std::string weakness = sandbox.empty() ? "" : sandbox_level().weakness();
  if (!weakness.empty()) out << "sandbox, weaker than on the newest kernels: " << weakness << '\n';
  if (total.programs > 0 && verified.evaluation.versions.page.empty()) {
    out << "page: programs were run natively alone: the compiler of the page was not built\n";
  }
  if (options.timings) {
    out << timings_table(verified.evaluation.times);
    if (const auto traffic = verified.store.traffic()) out << traffic_text(*traffic);
  }
  if (!options.trace.empty()) {
    write_trace(verified.evaluation.times, open_out_place(options.trace, options.course));
  }
  if (!options.report.empty()) {
    write_report(
        {verified.course ? &*verified.course : nullptr, verified.evaluation, verified.seconds},
        assets_folder(), std::filesystem::absolute(options.report), options.course);
    out << "report: " << options.report.lexically_normal().string() << "/index.html\n";
  }
  return verified;
}

}  // namespace mjcourse
