#include "evaluate/programs/example.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "base/out_folder.h"
#include "base/stopwatch.h"
#include "base/temporary_folder.h"
#include "evaluate/programs/compile_errors.h"
#include "evaluate/programs/compiled_recipe.h"
#include "evaluate/programs/judge_run.h"
#include "evaluate/programs/page_run.h"
#include "evaluate/programs/program_files.h"
#include "evaluate/programs/quoted_includes.h"
#include "evaluate/programs/records.h"
#include "evaluate/programs/region.h"
#include "lesson/syntax/linked_libraries.h"
#include "physics/mesa.h"
#include "process/open_to_all.h"
#include "report/refused_file.h"
#include "toolchain/containment.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostRecords = 16 << 20;  // bytes

// What the program wrote into `file` for its lesson; a fault is shown where the code names the
// record.
Records records_in(const fs::path& file, const LocatedText& code, const Example& example,
                   const Lesson& lesson, Diagnostics& diagnostics) {
  const auto report = [&](Span span, const std::string& message, const std::string& cure) {
    diagnostics.push_back(
        error_at(place_of(*lesson.source, span), "E-example-record", message, cure));
  };
  if (fs::file_size(file) > kMostRecords) {
    report(example.span, "the program reported more than 16 MiB to the lesson",
           "report what the lesson shows");
    return {};
  }
  std::vector<RecordFault> faults;
  Records records =
      read_records(DiskFiles(file.parent_path()).read(file.filename()).value(), faults);
  if (!example.quoted) return records;
  for (const RecordFault& fault : faults) {
    const std::size_t at = code.text.find("\"" + fault.name + "\"");
    const bool found = !fault.name.empty() && at != code.text.npos && !code.offsets.empty();
    report(found ? code.span(at, at + fault.name.size() + 2) : example.span, fault.message,
           fault.cure);
  }
  return records;
}

// `text` without the folders that this build happened to use.
std::string without_folders(std::string text, const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    const std::string prefix = folder.lexically_normal().string() + "/";
    for (std::size_t at = 0; (at = text.find(prefix, at)) != text.npos;)
      text.erase(at, prefix.size());
  }
  return text;
}

// The command line that runs `program` in an empty folder of its own; what it reports goes into the
// file `records`.
Command run_command(const Example& example, const CompiledExample& program, const fs::path& own,
                    const fs::path& root, const fs::path& records) {
  Command command;
  command.arguments = {program.binary.string()};
  command.arguments.insert(command.arguments.end(), example.arguments.begin(),
                           example.arguments.end());
  command.folder = own;
  command.environment = {"MJCOURSE_MODELS=" + fs::absolute(root / "models").string(),
                         "MJCOURSE_RECORDS=" + fs::absolute(records).string()};
  command.seconds = example.seconds;
  command.sandbox = program_sandbox(program.binary, command.folder, records, root);
  if (example.handed_in) command.sandbox->add = fs::absolute(records);
  command.record_opened = true;
  if (draws(program.code.text)) {
    const OutFolder folder =
        OutFolder(program.folder->path()).inner(own.filename().string() + ".shaders");
    const LentShaders shaders = lend_shaders_to(folder.path());
    command.environment.insert(command.environment.end(), shaders.variables.begin(),
                               shaders.variables.end());
    command.sandbox->write.push_back(shaders.own);
    if (!shaders.ours.empty()) {
      command.sandbox->read.push_back(shaders.ours);
      if (!can_be_read_by_all(shaders.ours)) command.sandbox->reads_all = true;
    }
  }
  return command;
}

// The folder of the program, where that includes headers from there; "" where it does not.
fs::path folder_beside(const Example& example, const LocatedText& code,
                       WorkerContext& worker_context) {
  const fs::path folder =
      fs::absolute(worker_context.root() / example.file.text).lexically_normal().parent_path();
  bool holds_some = false;
  for (const std::string& name : quoted_includes(code.text)) {
    worker_context.trace().file(folder / name);
    holds_some = holds_some || fs::exists(folder / name);
  }
  return holds_some ? folder : fs::path();
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

// How a compiler's messages call the text, and from which line on it counts there. The refusal on
// the page is what a learner who builds the file sees.
CompiledText name_of(const Example& example, const LocatedText& code, const Lesson& lesson) {
  if (code.offsets.empty() || !example.compiles) return {code, 1, example.file.text, example.span};
  return {code, lesson.source->position(code.span(0, 0).begin).line, lesson.source->path(),
          example.span};
}

// Without a place; it is the example's.
Diagnostic& place_at(const Example& example, const Lesson& lesson, Diagnostic wrong,
                     Diagnostics& diagnostics) {
  wrong.place = place_of(*lesson.source, example.span);
  return diagnostics.emplace_back(std::move(wrong));
}

}  // namespace

std::optional<CompiledExample> compile_example(const Example& example, const LocatedText& code,
                                               const Lesson& lesson, WorkerContext& worker_context,
                                               Diagnostics& diagnostics) {
  const auto report = [&](Diagnostic wrong) {
    place_at(example, lesson, std::move(wrong), diagnostics);
    return std::nullopt;
  };
  if (auto why = worker_context.run_context().why_nothing_runs()) return report(*std::move(why));
  const std::optional<Compiler>& compiler = worker_context.run_context().compiler();
  if (!compiler) return report(no_compiler());
  const fs::path beside = folder_beside(example, code, worker_context);
  if (!beside.empty()) {
    if (auto refused = refused_beside(example, worker_context.root())) {
      return report(*std::move(refused));
    }
  }
  CompiledExample program{std::make_unique<TemporaryFolder>(), code, {}, {}};
  const fs::path& folder = program.folder->path();
  const CompiledText text = name_of(example, code, lesson);
  const fs::path source = folder / (example.name() + ".cpp");
  program.binary = folder / example.name();
  write_file(source,
             "#line " + std::to_string(text.first_line) + " \"" + text.name + "\"\n" + code.text);
  program.compiled = compiler->compile(source, program.binary, folder, example.optimize, beside);
  trace_compilation(program.compiled, source, worker_context);
  return program;
}

std::optional<ExampleResult> run_example(const Example& example, CompiledExample& program,
                                         const Lesson& lesson, WorkerContext& worker_context,
                                         Diagnostics& diagnostics) {
  const fs::path& folder = program.folder->path();
  // Hidden, because a program may have any other name; and none has been there before, so what a
  // former run left behind lies elsewhere.
  const std::string run_name = ".run-" + std::to_string(++program.runs);
  const fs::path records = folder / (run_name + ".records");
  const OutFolder out(folder);
  out.inner(run_name);
  out.write(records.filename(), "");
  const Stopwatch stopwatch;
  Outcome outcome =
      run(run_command(example, program, folder / run_name, worker_context.root(), records));
  const double seconds = stopwatch.seconds();
  trace_run(outcome, folder, worker_context);
  std::vector<std::string> files =
      program_files(program.compiled, outcome, worker_context.run_context());
  if (auto wrong = judge_run(outcome, {"program", example.seconds, example.exit_code})) {
    place_at(example, lesson, *std::move(wrong), diagnostics);
    return std::nullopt;
  }
  ExampleResult result{as_shown(program.code.text), std::move(outcome.out),
                       records_in(records, program.code, example, lesson, diagnostics), seconds,
                       std::move(files)};
  result.page = run_in_page(example, program.code.text, result, worker_context);
  return result;
}

std::optional<ExampleResult> evaluate_example(const Example& example, const LocatedText& code,
                                              const Lesson& lesson, WorkerContext& worker_context,
                                              Diagnostics& diagnostics) {
  auto program = compile_example(example, code, lesson, worker_context, diagnostics);
  if (!program) return std::nullopt;
  const fs::path& root = worker_context.root();
  const Compiled& compiled = program->compiled;
  if (!example.compiles && compiled.refused()) {
    const std::vector<fs::path> folders{fs::absolute(root), root, program->folder->path()};
    return ExampleResult{as_shown(code.text), without_folders(compiled.raw, folders)};
  }
  report_compile_messages(compiled, name_of(example, code, lesson), lesson, root, diagnostics);
  if (!compiled.succeeded) return std::nullopt;
  if (!example.compiles) {
    place_at(example, lesson,
             error_at({}, "E-example-compiles",
                      "the program compiles, but the lesson says that it does not",
                      "remove `expect=compile-error`, or correct what the lesson says"),
             diagnostics);
    return std::nullopt;
  }
  return run_example(example, *program, lesson, worker_context, diagnostics);
}

}  // namespace mjcourse
