#include "evaluate/programs/page_run.h"

#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

#include "actions/page_program.h"
#include "base/cpp_includes.h"
#include "base/files.h"
#include "base/running_text.h"
#include "base/utf8.h"
#include "evaluate/programs/record_diff.h"
#include "evaluate/programs/records.h"
#include "findings/path_in_folder.h"

namespace mjcourse {
namespace {

// Wall clock: of a compiler that begins cold, on a machine that has more to do; and of the run.
constexpr double kCompileSeconds = 90, kTimesAsLong = 5;
// With which a program ends that MuJoCo stopped (examples/include/mjcourse/handlers.cpp).
constexpr int kMujocoError = 70;
// How the page begins to say that it runs one thread after the other
// (site/browser/cpp/execution.ts).
constexpr const char* kThreadWaits = "a thread waits";
// What a message quotes of the compiler, and of a program.
constexpr std::size_t kMostQuoted = 120;

// A file of the course, or of the tool where the course has none under the name.
std::string read_either(const std::string& path, const RunContext& run_context) {
  const DiskFiles course(run_context.root());
  const std::string include = "examples/include/";
  if (auto bytes = course.read(path)) return *std::move(bytes);
  if (path.starts_with(include)) {
    const std::string name = path.substr(include.size());
    const auto folder = folder_with(name, run_context.include_folders());
    if (auto bytes = read_file(folder / name)) return *std::move(bytes);
  }
  throw LostFile(path + ": was read, and is gone");
}

PageProgram page_program(const Example& example, const std::string& code,
                         const std::vector<std::string>& files, WorkerContext& worker_context) {
  PageProgram program{example.name() + ".cpp", {}, example.arguments};
  program.files[program.main] = code;
  for (const std::string& path : files) {
    worker_context.trace().file(path);
    program.files[path_in_folder(path, example)] = read_either(path, worker_context.run_context());
  }
  return program;
}

// Of a process that gave no answer.
std::string why_no_answer(const Outcome& outcome) {
  switch (outcome.end) {
    case Outcome::End::timed_out:
      return "it does not come to an end there, or takes too long";
    case Outcome::End::exhausted:
      return "it takes more memory than a page has";
    case Outcome::End::killed_by_signal:
      return std::string("it ends the page's engine: ") + strsignal(outcome.code);
    case Outcome::End::refused:
      throw std::runtime_error("the page's compiler tried to " + outcome.refused);
    default:
      throw std::runtime_error("the page's compiler gave no answer: " +
                               outcome.err.substr(0, outcome.err.find('\n')));
  }
}

std::string quoted(const std::string& words) {
  const std::string line = readable(words.substr(0, words.find('\n')));
  return line.size() <= kMostQuoted ? line : beginning_of(line, kMostQuoted) + " …";
}

// Where the program ended in another way than natively; "" where it did not.
std::string other_end(const PageEnd& end, int expected) {
  const std::string said =
      quoted(end.message) + (end.line > 0 ? " (line " + std::to_string(end.line) + ")" : "");
  if (end.how == "exit") {
    if (end.code == expected) return "";
    return "exits with code " + std::to_string(end.code) + ", and natively with " +
           std::to_string(expected);
  }
  if (end.how == "error") return expected == kMujocoError ? "" : "is stopped by MuJoCo: " + said;
  if (end.how == "uncaught") return "throws " + said;
  return "ends with: " + said;
}

PageRun judge(const PageEnd& end, const Example& example, const ExampleResult& native) {
  if (!end.compiled()) return {kPageRefuses + quoted(end.refusal)};
  if (end.how == "memory") return {"it takes more memory than a page has"};
  if (end.message.starts_with(kThreadWaits)) return {quoted(end.message)};
  PageRun run;
  run.otherwise = other_end(end, example.exit_code);
  if (end.out != native.output) run.outputs = {native.output, end.out};
  if (!run.otherwise.empty()) return run;
  std::vector<RecordFault> faults;  // natively, there were none
  const Records records = read_records(end.records, faults);
  const std::string differs = example.quoted ? record_diff(native.records, records)
                                             : check_diff(native.records.checks, records.checks);
  if (!differs.empty()) {
    run.otherwise = "reports otherwise: " + differs;
  }
  return run;
}

}  // namespace

std::optional<PageRun> run_in_page(const Example& example, const std::string& code,
                                   const ExampleResult& native, WorkerContext& worker_context) {
  PageProcess* const process = worker_context.page_process();
  if (process == nullptr) return std::nullopt;
  if (!example.native.empty()) return PageRun{example.native};
  if (draws(code)) return PageRun{"it draws, and the page's engine only simulates"};
  const RunContext& run_context = worker_context.run_context();
  const auto end =
      run_page_program(page_program(example, code, native.files, worker_context),
                       kCompileSeconds + kTimesAsLong * native.run_seconds, *run_context.page(),
                       *process, run_context.actions(), worker_context.trace());
  if (end) return judge(*end, example, native);
  worker_context.trace().unknown();  // another machine may do better
  return PageRun{why_no_answer(end.error())};
}

}  // namespace mjcourse
