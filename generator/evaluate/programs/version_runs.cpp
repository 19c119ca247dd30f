#include "evaluate/programs/version_runs.h"

#include <charconv>
#include <utility>

#include "base/text_lines.h"
#include "base/utf8.h"
#include "evaluate/programs/joined_programs.h"
#include "evaluate/programs/page_run.h"

namespace mjcourse {
namespace {

// Of the joined program: in place 0 the solution as its author runs it, and behind it each version
// as a stranger's.
constexpr std::size_t kAuthors = 0;

std::size_t place_of_version(std::size_t index) {
  return index + 1;
}

std::optional<std::string> joined(const std::vector<std::string>& versions, const JudgeKey& key,
                                  const std::string& path) {
  std::vector<Version> all{{versions[0], tell_answers(key)}};
  for (const std::string& version : versions) all.push_back({version, tell_findings(key)});
  return joined_programs(all, path, reporting_checks(key), end_of_checks(key));
}

// All but the solution, which its page compiles as a program of its own.
std::optional<std::string> joined_for_page(const std::vector<std::string>& versions,
                                           const std::string& path) {
  if (versions.size() < 3) return std::nullopt;
  std::vector<Version> all;
  for (std::size_t i = 1; i < versions.size(); ++i) all.push_back({versions[i]});
  return joined_programs(all, path);
}

// The run of a program, and what that reported.
struct Heard {
  ExampleResult result;
  std::string reports;

  Judge told_to(Judge judge) const {
    for (const std::string_view line : lines_of(reports)) judge.hear(line);
    return judge;
  }
};

// What a program printed may be no text: it is no fault of a hand-in.
std::string shown_output(const std::string& output) {
  std::string text;
  for (const std::string_view line : lines_of(output)) text += readable_output(line) + "\n";
  return text;
}

struct Judged {
  const Example& program;
  const Lesson& lesson;
  WorkerContext& worker_context;
  const JudgeKey& key;
  Diagnostics& diagnostics;

  // `judge` hears the run, and `answers` is all that its answers depend on.
  RunAs as(Judge& judge, const std::string& answers) const {
    const auto answer = [&judge](std::string_view line) { return judge.hear(line); };
    return {true, key.seed, RunListener{answers, answer}, key.is_kept};
  }

  std::optional<Heard> heard(const LocatedText& text, NativeRun run) const {
    std::string reports = std::exchange(run.records, "").value_or("");
    if (!key.is_kept) run.outcome.out = shown_output(run.outcome.out);
    auto result = judge_native(program, text, std::move(run), lesson, diagnostics);
    if (!result) return std::nullopt;
    return Heard{*std::move(result), std::move(reports)};
  }

  // One text, of which `told` says what its checks tell. In a namespace, what it defines takes the
  // place of no function of the C library. Of a hand-in, whose code is in marks, it is not for the
  // code to say whether it can be put there: it is put there wherever the solution is.
  struct Alone {
    Example program;
    LocatedText whole;
    std::optional<NativeProgram> native;  // nothing (reported) where nothing can be run
    bool is_joined = false;
  };
  Alone alone(const std::string& text, const std::string& told) const {
    const std::string& path = program.file.text;
    Alone one{program, {}, std::nullopt};
    const std::string checks = reporting_checks(key), end = end_of_checks(key);
    auto joined = joined_programs({{text, told, key.name}}, path, checks, end);
    if (!joined) joined = joined_programs({{text, told}}, path, checks, end);
    one.is_joined = joined.has_value();
    if (joined) {
      one.whole.text = *std::move(joined);
      one.program.arguments = joined_arguments(0, program.arguments);
    } else {
      one.whole.text = with_behind_includes(text, checks + told, path);
    }
    auto native = native_program(one.program, one.whole, lesson, worker_context, diagnostics, true);
    if (native) one.native.emplace(*std::move(native));
    return one;
  }

  // Messages quote `text`.
  std::optional<Heard> run(Alone& alone, const std::string& text, const RunAs& as) const {
    const LocatedText quoted{text, {}};
    if (!alone.native) return std::nullopt;
    auto run =
        compiled_run(alone.program, quoted, *alone.native, lesson, worker_context, diagnostics, as);
    if (!run) return std::nullopt;
    return heard(quoted, *std::move(run));
  }

  std::optional<Heard> run_alone(const std::string& text, const std::string& told,
                                 const RunAs& as) const {
    Alone one = alone(text, told);
    return run(one, text, as);
  }

  std::optional<JudgedRun> judged(std::optional<Heard> heard, const Answers& answers) const {
    if (!heard) return std::nullopt;
    const Judge judge = heard->told_to(Judge(answers, key.mark));
    if (judge.is_forged()) {
      diagnostics.push_back(error_at(place_of(*lesson.source, program.span), "E-hand-in",
                                     "a check was not made by the program itself"));
      return std::nullopt;
    }
    JudgedRun run{std::move(heard->result), judge.verdict()};
    for (const JudgedCheck& check : run.verdict) {
      if (check.calls > 0) run.result.records.checks.push_back(check);
    }
    return run;
  }
};

std::optional<std::string> expand(NativeProgram& program, const JudgeKey& key) {
  const auto whole = program.preprocessed();
  return whole ? find_marked_code(key, *whole) : std::nullopt;
}

// The line that `at` is from, by the last mark in front of it (`# 7 "a.cpp"`). 0 where there is
// none.
int line_of(std::string_view preprocessed, std::size_t at) {
  int line = 0;
  std::size_t begin = 0;
  for (const std::string_view text : lines_of(preprocessed)) {
    if (at < begin + text.size()) return line;
    begin += text.size() + 1;
    ++line;
    if (text.starts_with("# ")) {
      std::from_chars(text.data() + 2, text.data() + text.size(), line);
    }
  }
  return line;
}

// A fault in the preprocessor's output for the code: something that no hand-in may have.
std::optional<Diagnostic> expanded_fault(NativeProgram& program, const HandedInProgram& handed_in,
                                         Place place, const Toolchain& toolchain) {
  const auto code = expand(program, handed_in.key);
  const auto tokens = code ? raw_tokens({*code}, toolchain) : tl::unexpected(std::string());
  if (!tokens) {
    return error_at(std::move(place), "E-hand-in",
                    "what the preprocessor makes of the text cannot be read");
  }
  const auto fault = handed_in.rules.expanded_fault(*code, tokens->front());
  if (!fault) return std::nullopt;
  const SourceText quoted(handed_in.program.file.text, handed_in.quoted);
  const int line = line_of(*code, fault->span.begin);
  const std::size_t begin = quoted.line_start(line);
  return error_at(place_of(quoted, {begin, begin + quoted.line(line).size()}), "E-hand-in",
                  fault->why);
}

}  // namespace

std::optional<JudgedRun> run_handed_in(const HandedInProgram& handed_in, const Lesson& lesson,
                                       WorkerContext& worker_context, Diagnostics& diagnostics) {
  const JudgeKey& key = handed_in.key;
  const Judged judged{handed_in.program, lesson, worker_context, key, diagnostics};
  Judge judge(handed_in.answers, key.mark);
  const Place place = place_of(*lesson.source, handed_in.program.span);
  auto one = judged.alone(handed_in.text, tell_findings(key));
  if (handed_in.answers.is_ended && !one.is_joined) {
    diagnostics.push_back(error_at(
        place, "E-hand-in", "`int main(` does not begin a line, as it does in the solution"));
    return std::nullopt;
  }
  if (one.native && one.native->compile().succeeded) {
    auto fault = expanded_fault(*one.native, handed_in, place,
                                worker_context.run_context().compiler()->toolchain());
    if (fault) {
      diagnostics.push_back(*std::move(fault));
      return std::nullopt;
    }
  }
  return judged.judged(judged.run(one, handed_in.quoted, judged.as(judge, handed_in.answers.key())),
                       handed_in.answers);
}

std::optional<std::string> expanded_code(const Example& program, const std::string& text,
                                         const JudgeKey& key, const Lesson& lesson,
                                         WorkerContext& worker_context) {
  Diagnostics none;
  const Judged judged{program, lesson, worker_context, key, none};
  auto one = judged.alone(text, tell_findings(key));
  return one.native ? expand(*one.native, key) : std::nullopt;
}

VersionRuns::VersionRuns(Example program, std::vector<std::string> versions, const Lesson& lesson,
                         WorkerContext& worker_context, JudgeKey key)
    : program_(std::move(program)),
      versions_(std::move(versions)),
      lesson_(lesson),
      worker_context_(worker_context),
      key_(std::move(key)) {
  auto text = joined(versions_, key_, program_.file.text);
  if (!text) return;
  text_ = {*std::move(text), {}};
  Diagnostics none;  // each version alone says what is wrong with it
  auto joined = native_program(program_, *text_, lesson_, worker_context_, none, true);
  if (joined) joined_.emplace(*std::move(joined));
}

Example VersionRuns::at(std::size_t place) const {
  Example program = program_;
  program.arguments = joined_arguments(place, program_.arguments);
  return program;
}

std::optional<NativeRun> VersionRuns::run_joined(std::size_t place, const RunAs& as) {
  if (!joined_) return std::nullopt;
  if (auto run = known_run(at(place), *joined_, as)) return run;
  if (!joined_->find_refusal()) {
    Diagnostics none;
    if (auto run = compiled_run(at(place), *text_, *joined_, lesson_, worker_context_, none, as)) {
      return run;
    }
    // So that nobody compiles it again.
    if (key_.is_kept && joined_->compile().refused()) joined_->refusal();
  }
  joined_.reset();
  return std::nullopt;
}

std::optional<Answers> VersionRuns::answers(Diagnostics& diagnostics, const std::string& seed) {
  const Judged judged{program_, lesson_, worker_context_, key_, diagnostics};
  Judge author(key_.mark);
  RunAs as = judged.as(author, "");
  if (!seed.empty()) as.seed = seed;
  auto run = run_joined(kAuthors, as);
  const auto heard = run ? judged.heard(*text_, *std::move(run))
                         : judged.run_alone(versions_[0], tell_answers(key_), as);
  if (!heard) return std::nullopt;
  return heard->told_to(Judge(key_.mark)).answers();
}

std::optional<JudgedRun> VersionRuns::run(std::size_t index, const Answers& answers,
                                          Diagnostics& diagnostics) {
  const Judged judged{program_, lesson_, worker_context_, key_, diagnostics};
  Judge judge(answers, key_.mark);
  const RunAs as = judged.as(judge, answers.key());
  const std::size_t place = place_of_version(index);
  auto run = run_joined(place, as);
  return judged.judged(run ? judged.heard(*text_, *std::move(run))
                           : judged.run_alone(versions_[index], tell_findings(key_), as),
                       answers);
}

bool VersionRuns::is_known() {
  if (!joined_) return false;
  Diagnostics none;
  const Judged judged{program_, lesson_, worker_context_, key_, none};
  Judge author(key_.mark);
  return known_run(at(kAuthors), *joined_, judged.as(author, "")).has_value();
}

std::optional<PageRun> VersionRuns::run_in_page(std::size_t index, const ExampleResult& native) {
  if (const auto text = joined_for_page(versions_, program_.file.text)) {
    Example version = program_;
    version.arguments = joined_arguments(index - 1, program_.arguments);
    auto page = mjcourse::run_in_page(version, *text, native, worker_context_);
    // What the page's compiler refuses, it may take one by one.
    if (!page || !page->why_not.starts_with(kPageRefuses)) return page;
  }
  return mjcourse::run_in_page(program_, versions_[index], native, worker_context_);
}

}  // namespace mjcourse
