#include "evaluate/programs/example.h"

#include <utility>
#include <vector>

#include "evaluate/programs/compile_errors.h"
#include "evaluate/programs/judge_run.h"
#include "evaluate/programs/records.h"
#include "evaluate/programs/region.h"
#include "report/refused_file.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// What the program wrote for its lesson; a fault is shown where the code names the record.
Records records_in(const NativeRun& run, const LocatedText& code, const Example& example,
                   const Lesson& lesson, Diagnostics& diagnostics) {
  const auto report = [&](Span span, const std::string& message, const std::string& cure) {
    diagnostics.push_back(
        error_at(place_of(*lesson.source, span), "E-example-record", message, cure));
  };
  if (!run.records) {
    report(example.span, "the program reported more than 16 MiB to the lesson",
           "report what the lesson shows");
    return {};
  }
  std::vector<RecordFault> faults;
  Records records = read_records(*run.records, faults);
  if (!example.quoted) return records;
  for (const RecordFault& fault : faults) {
    const std::size_t at = code.text.find("\"" + fault.name + "\"");
    const bool found = !fault.name.empty() && at != code.text.npos && !code.offsets.empty();
    report(found ? code.span(at, at + fault.name.size() + 2) : example.span, fault.message,
           fault.cure);
  }
  return records;
}

// The first file below the folder of the program that is never read; a compiler waits for ever at
// a pipe.
std::optional<Diagnostic> refused_beside(const Example& example, const fs::path& root) {
  const DiskFiles files(root);
  for (const DiskFiles::Entry& entry :
       files.below(fs::path(example.file.text).parent_path().string())) {
    const auto refusal = entry.is_folder ? std::nullopt : files.refusal(entry.path);
    if (refusal) return refused_file({}, entry.path, *refusal);
  }
  return std::nullopt;
}

// Without a place; it is the example's.
Diagnostic& place_at(const Example& example, const Lesson& lesson, Diagnostic wrong,
                     Diagnostics& diagnostics) {
  wrong.place = place_of(*lesson.source, example.span);
  return diagnostics.emplace_back(std::move(wrong));
}

NativeRequest request_of(const Example& example, const RunAs& as) {
  return {example.arguments, example.seconds, example.exit_code, as.seed, as.listener, as.is_kept};
}

ExampleResult refused_result(const LocatedText& code, std::string words) {
  return {as_shown(code.text), std::move(words)};
}

}  // namespace

std::optional<NativeProgram> native_program(const Example& example, const LocatedText& code,
                                            const Lesson& lesson, WorkerContext& worker_context,
                                            Diagnostics& diagnostics, bool handed_in) {
  const auto report = [&](Diagnostic wrong) {
    place_at(example, lesson, std::move(wrong), diagnostics);
    return std::nullopt;
  };
  if (auto why = worker_context.run_context().why_nothing_runs()) return report(*std::move(why));
  if (!worker_context.run_context().compiler()) return report(no_compiler());
  NativeProgram program({example.name(), example.file.text, code.text, example.optimize, handed_in},
                        worker_context.action_context());
  if (!program.beside().empty()) {
    if (auto refused = refused_beside(example, worker_context.root())) {
      return report(*std::move(refused));
    }
  }
  return program;
}

std::optional<NativeRun> known_run(const Example& example, const NativeProgram& program,
                                   const RunAs& as) {
  return program.find(request_of(example, as));
}

std::optional<NativeRun> compiled_run(const Example& example, const LocatedText& code,
                                      NativeProgram& program, const Lesson& lesson,
                                      WorkerContext& worker_context, Diagnostics& diagnostics,
                                      const RunAs& as) {
  if (auto run = known_run(example, program, as)) return run;
  const Compiled& compiled = program.compile();
  report_compile_messages(compiled, {code, example.file.text, example.span}, lesson,
                          worker_context.root(), diagnostics);
  if (!compiled.succeeded) return std::nullopt;
  return program.run(request_of(example, as));
}

std::optional<ExampleResult> judge_native(const Example& example, const LocatedText& code,
                                          NativeRun run, const Lesson& lesson,
                                          Diagnostics& diagnostics) {
  if (auto wrong = judge_run(run.outcome, {"program", example.seconds, example.exit_code})) {
    place_at(example, lesson, *std::move(wrong), diagnostics);
    return std::nullopt;
  }
  Records records = records_in(run, code, example, lesson, diagnostics);
  return ExampleResult{as_shown(code.text), std::move(run.outcome.out), std::move(records),
                       run.seconds, std::move(run.files)};
}

bool is_known(const Example& example, const LocatedText& code, const Lesson& lesson,
              WorkerContext& worker_context) {
  Diagnostics none;
  const auto program = native_program(example, code, lesson, worker_context, none);
  if (!program) return false;
  return example.compiles ? known_run(example, *program).has_value()
                          : program->find_refusal().has_value();
}

std::optional<ExampleResult> evaluate_example(const Example& example, const LocatedText& code,
                                              const Lesson& lesson, WorkerContext& worker_context,
                                              Diagnostics& diagnostics) {
  auto program = native_program(example, code, lesson, worker_context, diagnostics);
  if (!program) return std::nullopt;
  if (example.compiles) {
    auto run = compiled_run(example, code, *program, lesson, worker_context, diagnostics);
    if (!run) return std::nullopt;
    return judge_native(example, code, *std::move(run), lesson, diagnostics);
  }
  if (auto words = program->find_refusal()) return refused_result(code, *std::move(words));
  const Compiled& compiled = program->compile();
  if (compiled.refused()) return refused_result(code, program->refusal());
  report_compile_messages(compiled, {code, example.file.text, example.span}, lesson,
                          worker_context.root(), diagnostics);
  if (!compiled.succeeded) return std::nullopt;
  place_at(example, lesson,
           error_at({}, "E-example-compiles",
                    "the program compiles, but the lesson says that it does not",
                    "remove `expect=compile-error`, or correct what the lesson says"),
           diagnostics);
  return std::nullopt;
}

}  // namespace mjcourse
