#include "evaluate/programs/exercise.h"

#include <re2/re2.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "actions/lent_headers.h"
#include "base/files.h"
#include "base/nearest.h"
#include "evaluate/programs/hand_in_text.h"
#include "evaluate/programs/version_runs.h"

namespace mjcourse {
namespace {

using Variant = ExerciseText::Variant;
using Checks = std::vector<Check>;

// The words of the line of `file`.
Span span_of_line(const SourceText& file, int line) {
  const std::string_view text = file.line(line);
  const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  return {file.line_start(line) + begin, file.line_start(line) + text.size()};
}

Place place_of_line(const SourceText& file, int line) {
  return place_of(file, span_of_line(file, line));
}

// Of a program's text, which stands in the lesson or in a file of its own.
Place place_of_line(const LocatedText& code, int line, const Example& program,
                    const Lesson& lesson) {
  const SourceText text(program.file.text, code.text);
  if (code.offsets.empty()) return place_of_line(text, line);
  const Span span = span_of_line(text, line);
  return place_of(*lesson.source, code.span(span.begin, span.end));
}

std::string name_of(const Variant& variant) {
  return variant.name.empty() ? "the starter" : "the wrong variant `" + variant.name + "`";
}

std::vector<std::string> failing(const Checks& checks) {
  std::vector<std::string> names;
  for (const Check& check : checks) {
    if (!check.holds) names.push_back(check.what);
  }
  return names;
}

std::string lines(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += "  " + name + "\n";
  return text;
}

Diagnostic at_variant(const Variant& variant, const ExerciseText& text, const Exercise& exercise,
                      const Lesson& lesson, std::string id, std::string message, std::string cure) {
  Diagnostic wrong = error_at(place_of_line(text.file(), variant.mark), std::move(id),
                              std::move(message), std::move(cure));
  wrong.notes.push_back({"the lesson has this exercise", place_of(*lesson.source, exercise.span)});
  return wrong;
}

// What one run of each program checked.
struct Made {
  Checks shown, hidden;

  Checks all() const {
    Checks both = shown;
    both.insert(both.end(), hidden.begin(), hidden.end());
    return both;
  }
};

// The lesson quotes the solution's.
Example not_quoted(Example program) {
  program.quoted = false;
  return program;
}

// Whole programs: that of the solution, and those of the variants.
std::vector<std::string> shown_versions(const ExerciseText& text) {
  std::vector<std::string> versions{std::string(text.file().text())};
  for (const Variant& variant : text.variants()) versions.push_back(text.in_place(variant));
  return versions;
}

std::vector<std::string> hidden_versions(const Exercise& exercise, const ExerciseFiles& files) {
  std::vector<std::string> versions{hidden_text(exercise, files, files.text.solution())};
  for (const Variant& variant : files.text.variants()) {
    versions.push_back(hidden_text(exercise, files, variant.code));
  }
  return versions;
}

// May it? A seed() in a comment costs three runs.
bool uses_seed(const std::string& program) {
  static const RE2 call(R"(\bseed\s*\()");
  return RE2::PartialMatch(program, call);
}

Checks checks_of(const Answers& answers) {
  Checks checks;
  for (const Answers::Known& known : answers.checks) checks.push_back(known.check);
  return checks;
}

std::size_t version_of(std::size_t variant) {
  return variant + 1;  // behind the solution
}

// A program of the exercise, with all that is to stand in its region.
struct TriedProgram {
  Example program;
  LocatedText text;  // with the solution
  VersionRuns runs;
  Answers answers = {};
};

class Trials {
 public:
  Trials(const Exercise& exercise, const ExerciseFiles& files, const Lesson& lesson,
         WorkerContext& worker_context, Diagnostics& diagnostics)
      : exercise_(exercise),
        files_(files),
        lesson_(lesson),
        worker_context_(worker_context),
        diagnostics_(diagnostics),
        shown_{not_quoted(exercise.program),
               {std::string(files.text.file().text()), {}},
               {not_quoted(exercise.program), shown_versions(files.text), lesson, worker_context}} {
    if (!files.hidden) return;
    const Example program = hidden_program(exercise);
    hidden_.emplace(
        TriedProgram{program,
                     {*files.hidden, {}},
                     {program, hidden_versions(exercise, files), lesson, worker_context}});
  }

  std::optional<ExerciseResult> run() {
    const ExerciseText& text = files_.text;
    ExerciseResult result{text.program(text.starter().code), {}, {}};
    if (!read_texts() || !try_solution(shown_)) return std::nullopt;
    if (hidden_ && !try_solution(*hidden_)) return std::nullopt;
    if (hidden_) {
      for (const Check& check : checks_of(hidden_->answers)) result.hidden.push_back(check.what);
    }
    bool is_whole = true;
    for (std::size_t i = 0; i < text.variants().size(); ++i) {
      const Variant& variant = text.variants()[i];
      const std::optional<Made> made = made_by(i);
      if (made && made->shown.empty()) {
        fail(variant, "E-exercise-check", "the program makes no check",
             "check what its reader is to write: `expect(CONDITION, \"what should hold\")`");
        return std::nullopt;
      }
      if (made && judge(variant, *made)) {
        result.trials.push_back({variant.name, failing(made->all())});
      } else {
        is_whole = false;
      }
    }
    if (text.variants().size() == 1) {
      warn(text.starter(), "W-exercise-wrong", "no wrong variant shows that the checks refuse one",
           "add a mistake that people make: `// #wrong NAME: CHECK`, and the code in comments");
    }
    return is_whole ? std::optional(std::move(result)) : std::nullopt;
  }

 private:
  // May each of them be handed in? False (reported) where one may not.
  bool read_texts() {
    const RunContext& run_context = worker_context_.run_context();
    auto why = run_context.why_nothing_runs();
    if (!why && !run_context.compiler()) why = no_compiler();
    if (why) {
      why->place = place_of(*lesson_.source, exercise_.span);
      diagnostics_.push_back(*std::move(why));
      return false;
    }
    if (!read_headers(run_context.compiler()->toolchain())) return false;
    const auto own = hand_in_rules(files_.text, run_context.compiler()->toolchain());
    if (!own) return refuse("the exercise cannot be handed in: " + own.error(), "");
    for (std::size_t i = 0; i < own->faults.size(); ++i) {
      const auto& fault = own->faults[i];
      if (!fault) continue;
      const Variant* variant = i == 0 ? nullptr : &files_.text.variants()[i - 1];
      const std::string text = variant == nullptr ? files_.text.solution() : variant->code;
      const auto end = text.begin() + static_cast<std::ptrdiff_t>(fault->span.begin);
      const int line = static_cast<int>(std::count(text.begin(), end, '\n')) +
                       (variant == nullptr ? files_.text.solution_line() : variant->mark + 1);
      return refuse((variant == nullptr ? "the solution" : name_of(*variant)) +
                        " cannot be handed in: " + fault->why,
                    "write it without that: `grade` refuses such a text",
                    place_of_line(files_.text.file(), line));
    }
    return true;
  }

  // A check in a header beside the program is heard by nobody: what includes it has the plain ones.
  bool read_headers(const Toolchain& toolchain) {
    const std::filesystem::path folder =
        std::filesystem::path(exercise_.program.file.text).parent_path();
    const DiskFiles files(worker_context_.root() / folder);
    const std::vector<std::string> names =
        included_headers(files, shown_.text.text + files_.hidden.value_or(""));
    std::vector<std::string> texts;
    for (const std::string& name : names) texts.push_back(files.read(name).value_or(""));
    const auto tokens = texts.empty()
                            ? std::vector<RawTokens>()
                            : raw_tokens(texts, toolchain).value_or(std::vector<RawTokens>());
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      for (const RawToken& token : tokens[i]) {
        const std::string_view word = token.in(texts[i]);
        if (word != "expect" && word != "expect_near" && word != "expect_alike") continue;
        return refuse("a header makes a check, which `grade` does not hear",
                      "make it in the program itself: the header may have what it is made of",
                      place_of(SourceText(folder / names[i], texts[i]), {token.begin, token.end}));
      }
    }
    return true;
  }

  // What is reported of it says of which text it is. Warnings are of its program.
  template <typename Run>
  auto run_solution(const Run& run) {
    Diagnostics found;
    auto result = run(found);
    std::erase_if(found, [](const Diagnostic& one) { return one.severity == Severity::warning; });
    if (found.empty()) return result;
    if (found.front().id == "E-example-compile") {
      const Diagnostic& first = found.front();
      refuse(
          "the solution, handed in, does not compile",
          "there, expect_near() is a macro: put an argument that has a comma in braces or <> into "
          "parentheses");
      diagnostics_.back().detail = first.detail.empty() ? first.message : first.detail;
      return result;
    }
    Diagnostic& first = diagnostics_.emplace_back(std::move(found.front()));
    first.notes.push_back(
        {"so it is with the solution, handed in", place_of(*lesson_.source, exercise_.span)});
    return result;
  }

  // The answers, and whether they accept the solution; false (reported) where it fails a check.
  bool try_solution(TriedProgram& tried) {
    auto answers = run_solution([&](Diagnostics& found) { return tried.runs.answers(found); });
    if (!answers) return false;
    tried.answers = *std::move(answers);
    if (!tried.answers.hold()) return report_failing(tried);
    const auto ran =
        run_solution([&](Diagnostics& found) { return tried.runs.run(0, tried.answers, found); });
    if (!ran) return false;
    const auto fails = std::ranges::find(ran->verdict, false, &JudgedCheck::holds);
    if (fails == ran->verdict.end()) return try_seeds(tried);
    refuse("the solution, handed in, fails the check `" + fails->what + "`",
           "what is expected must not change from run to run");
    diagnostics_.back().detail = fails->found;
    return false;
  }

  // Each class that is graded has another seed.
  bool try_seeds(TriedProgram& tried) {
    if (!uses_seed(tried.text.text)) return true;
    for (const char* seed : {"2", "3", "4"}) {
      const auto other =
          run_solution([&](Diagnostics& found) { return tried.runs.answers(found, seed); });
      if (!other) return false;
      const Checks checks = checks_of(*other);
      const auto fails = std::ranges::find(checks, false, &Check::holds);
      if (fails == checks.end()) continue;
      refuse("where seed() gives " + std::string(seed) + ", the solution fails the check `" +
                 fails->what + "`",
             "`grade` draws another seed for each class: let the check hold for all inputs");
      diagnostics_.back().detail = fails->found;
      return false;
    }
    return true;
  }

  // Gives false. What the solution's own program fails, is told where that is run.
  bool report_failing(const TriedProgram& tried) {
    Diagnostics none;
    if (&tried == &shown_) {
      const auto plain =
          evaluate_example(tried.program, tried.text, lesson_, worker_context_, none);
      if (!plain || !failing(plain->records.checks).empty()) return false;
    }
    report_failing_checks(tried.program, tried.text, checks_of(tried.answers), lesson_,
                          diagnostics_);
    return false;
  }

  // With the variant in the solution's place.
  std::optional<Made> made_by(std::size_t index) {
    const Variant& variant = files_.text.variants()[index];
    auto ran = run(shown_, index, variant);
    if (!ran) return std::nullopt;
    Made made{std::move(ran->result.records.checks), {}};
    if (!hidden_) return made;
    auto more = run(*hidden_, index, variant);
    if (!more) return std::nullopt;
    made.hidden = std::move(more->result.records.checks);
    return made;
  }

  // What is reported says of which variant it is.
  std::optional<JudgedRun> run(TriedProgram& tried, std::size_t index, const Variant& variant) {
    Diagnostics found;
    auto result = tried.runs.run(version_of(index), tried.answers, found);
    for (Diagnostic& one : found) {
      // What is left to be written uses not all that is there for it.
      if (one.severity == Severity::warning) continue;
      one.notes.push_back({"with " + name_of(variant) + " in the place of the solution",
                           place_of_line(files_.text.file(), variant.mark)});
      diagnostics_.push_back(std::move(one));
    }
    return result;
  }

  bool judge(const Variant& variant, const Made& made) {
    if (!variant.name.empty()) return judge_wrong(variant, made);
    return !failing(made.shown).empty() ||
           fail(variant, "E-exercise-starter", "the starter passes each check",
                "leave something to do, or check what is to be done");
  }

  // Its reader is told one thing; hidden checks may fail besides, or instead.
  bool judge_wrong(const Variant& variant, const Made& made) {
    const auto is_named = [&](const std::string& check) {
      return check.starts_with(variant.check);
    };
    std::vector<std::string> known;
    for (const Check& check : made.all()) known.push_back(check.what);
    if (std::ranges::none_of(known, is_named)) {
      return fail(variant, "E-exercise-wrong", "there is no check `" + variant.check + "`",
                  suggest(variant.check, known));
    }
    const std::vector<std::string> fails = failing(made.all()), shown = failing(made.shown);
    if (fails.empty()) {
      return fail(variant, "E-exercise-wrong",
                  "no check refuses the wrong variant `" + variant.name + "`",
                  "check what it does otherwise than the solution");
    }
    if (std::ranges::any_of(fails, is_named) && shown.size() <= 1 &&
        std::ranges::all_of(shown, is_named)) {
      return true;
    }
    fail(variant, "E-exercise-wrong",
         "the wrong variant `" + variant.name + "` is to fail the check `" + variant.check +
             "` and no other that its reader sees",
         "where one check follows from another, leave it out: `expect` gives whether its "
         "condition holds");
    diagnostics_.back().detail = "it fails\n" + lines(fails);
    return false;
  }

  // Gives false.
  bool refuse(std::string message, std::string cure, const std::optional<Place>& place = {}) {
    const Place lessons = place_of(*lesson_.source, exercise_.span);
    Diagnostic& wrong = diagnostics_.emplace_back(error_at(
        place.value_or(lessons), "E-exercise-hand-in", std::move(message), std::move(cure)));
    if (place) wrong.notes.push_back({"the lesson has this exercise", lessons});
    return false;
  }

  // Gives false.
  bool fail(const Variant& variant, std::string id, std::string message, std::string cure) {
    diagnostics_.push_back(at_variant(variant, files_.text, exercise_, lesson_, std::move(id),
                                      std::move(message), std::move(cure)));
    return false;
  }

  void warn(const Variant& variant, std::string id, std::string message, std::string cure) {
    fail(variant, std::move(id), std::move(message), std::move(cure));
    diagnostics_.back().severity = Severity::warning;
  }

  const Exercise& exercise_;
  const ExerciseFiles& files_;
  const Lesson& lesson_;
  WorkerContext& worker_context_;
  Diagnostics& diagnostics_;
  TriedProgram shown_;
  std::optional<TriedProgram> hidden_;
};

}  // namespace

std::optional<ExerciseResult> evaluate_exercise(const Exercise& exercise,
                                                const ExerciseFiles& files, const Lesson& lesson,
                                                WorkerContext& worker_context,
                                                Diagnostics& diagnostics) {
  return Trials(exercise, files, lesson, worker_context, diagnostics).run();
}

std::optional<PageRun> evaluate_exercise_in_page(const Exercise& exercise,
                                                 const ExerciseFiles& files, const Lesson& lesson,
                                                 WorkerContext& worker_context,
                                                 Diagnostics& diagnostics) {
  VersionRuns versions(not_quoted(exercise.program), shown_versions(files.text), lesson,
                       worker_context);
  PageRun exercise_page;
  Diagnostics known;  // of the native runs
  const auto answers = versions.answers(known);
  if (!answers) return std::nullopt;
  const std::vector<Variant>& variants = files.text.variants();
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const auto native = versions.run(version_of(i), *answers, known);
    auto page = native ? versions.run_in_page(version_of(i), native->result) : std::nullopt;
    if (!page) return std::nullopt;
    if (!page->otherwise.empty()) {
      diagnostics.push_back(at_variant(
          variants[i], files.text, exercise, lesson, "E-page-output",
          "in the page, " + name_of(variants[i]) + " " + page->otherwise,
          "check what depends on no last digit, no size of a type and no C library; take "
          "expect_alike() where both numbers depend on what the reader writes; or say in the fence "
          "that no page runs it, and why: `native because=\"…\"`"));
      return std::nullopt;
    }
    // A reader begins with the starter.
    if (variants[i].name.empty()) exercise_page.why_not = page->why_not;
  }
  return exercise_page;
}

bool is_known(const Exercise& exercise, const ExerciseFiles& files, const Lesson& lesson,
              WorkerContext& worker_context) {
  return VersionRuns(not_quoted(exercise.program), shown_versions(files.text), lesson,
                     worker_context)
      .is_known();
}

void report_failing_checks(const Example& program, const LocatedText& code,
                           const std::vector<Check>& checks, const Lesson& lesson,
                           Diagnostics& diagnostics) {
  for (const Check& check : checks) {
    if (check.holds) continue;
    Diagnostic wrong = error_at(place_of_line(code, check.line, program, lesson), "E-check-fails",
                                "the program fails its own check `" + check.what + "`",
                                "correct the program, or what is checked");
    for (const std::string& words : {check.meaning, check.found}) {
      if (!words.empty()) wrong.detail += words + "\n";
    }
    wrong.notes.push_back({"the lesson has this program", place_of(*lesson.source, program.span)});
    diagnostics.push_back(std::move(wrong));
  }
}

void add_solution(const Exercise& exercise, const ExampleResult& solution, const Lesson& lesson,
                  ExerciseResult& result, Diagnostics& diagnostics) {
  result.checks = solution.records.checks;
  result.files = solution.files;
  result.page = solution.page;
  const auto is_failed = [&](const std::string& check) {
    return std::ranges::any_of(result.trials, [&](const ExerciseResult::Trial& trial) {
      return std::ranges::count(trial.fails, check) > 0;
    });
  };
  std::vector<std::string> idle;
  for (const Check& check : result.checks) {
    if (!is_failed(check.what)) idle.push_back(check.what);
  }
  for (const std::string& check : result.hidden) {
    if (!is_failed(check)) idle.push_back(check);
  }
  if (idle.empty()) return;
  Diagnostic& warning = diagnostics.emplace_back(error_at(
      place_of(*lesson.source, exercise.span), "W-exercise-check",
      idle.size() == 1 ? "the starter and the wrong variants all pass the check `" + idle[0] + "`"
                       : "there are checks that the starter and the wrong variants all pass",
      "it may be one that cannot fail: add a `// #wrong` variant for it, or remove it"));
  warning.severity = Severity::warning;
  if (idle.size() > 1) warning.detail = lines(idle);
}

}  // namespace mjcourse
