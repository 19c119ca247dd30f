#include "evaluate/programs/example.h"

#include <cstdint>
#include <utility>
#include <vector>

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

// The command line that runs `binary`, made of `code`, in an empty folder inside `folder`; what it
// reports goes into the file `records`.
Command run_command(const Example& example, const LocatedText& code, const fs::path& binary,
                    const fs::path& folder, const fs::path& root, const fs::path& records) {
  Command command;
  command.arguments = {binary.string()};
  command.arguments.insert(command.arguments.end(), example.arguments.begin(),
                           example.arguments.end());
  command.folder = folder / "run";
  fs::create_directory(command.folder);
  command.environment = {"MJCOURSE_MODELS=" + fs::absolute(root / "models").string(),
                         "MJCOURSE_RECORDS=" + fs::absolute(records).string()};
  command.seconds = example.seconds;
  write_file(records, "");
  command.sandbox = program_sandbox(binary, command.folder, records, root);
  command.record_opened = true;
  if (draws(code.text)) {
    const LentShaders shaders = lend_shaders_to(fs::absolute(folder / "shaders"));
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

}  // namespace

std::optional<ExampleResult> evaluate_example(const Example& example, const LocatedText& code,
                                              const Lesson& lesson, WorkerContext& worker_context,
                                              Diagnostics& diagnostics) {
  const auto report = [&](Diagnostic wrong) {
    wrong.place = place_of(*lesson.source, example.span);
    diagnostics.push_back(std::move(wrong));
    return std::nullopt;
  };
  if (auto why = worker_context.run_context().why_nothing_runs()) return report(*std::move(why));
  const std::optional<Compiler>& compiler = worker_context.run_context().compiler();
  if (!compiler) return report(no_compiler());
  const fs::path& root = worker_context.root();
  const fs::path beside = folder_beside(example, code, worker_context);
  if (!beside.empty()) {
    if (auto refused = refused_beside(example, root)) return report(*std::move(refused));
  }
  const std::string shown = as_shown(code.text);
  const TemporaryFolder folder;
  // The refusal on the page is what a learner who builds the file sees.
  const bool in_file = code.offsets.empty() || !example.compiles;
  const std::string shown_as = in_file ? example.file.text : lesson.source->path();
  const int first_line = in_file ? 1 : lesson.source->position(code.span(0, 0).begin).line;
  const fs::path source = folder.path() / (example.name() + ".cpp");
  const fs::path binary = folder.path() / example.name();
  write_file(source, "#line " + std::to_string(first_line) + " \"" + shown_as + "\"\n" + code.text);

  const Compiled compiled =
      compiler->compile(source, binary, folder.path(), example.optimize, beside);
  trace_compilation(compiled, folder.path(), worker_context);
  if (!example.compiles && compiled.refused()) {
    return ExampleResult{shown,
                         without_folders(compiled.raw, {fs::absolute(root), root, folder.path()})};
  }
  report_compile_messages(compiled, {code, first_line, shown_as, example.span}, lesson, root,
                          diagnostics);
  if (!compiled.succeeded) return std::nullopt;
  if (!example.compiles) {
    return report(error_at({}, "E-example-compiles",
                           "the program compiles, but the lesson says that it does not",
                           "remove `expect=compile-error`, or correct what the lesson says"));
  }
  const fs::path records = folder.path() / "records";
  const Stopwatch stopwatch;
  Outcome outcome = run(run_command(example, code, binary, folder.path(), root, records));
  const double seconds = stopwatch.seconds();
  trace_run(outcome, folder.path(), worker_context);
  std::vector<std::string> files = program_files(compiled, outcome, worker_context.run_context());
  if (auto wrong = judge_run(outcome, {"program", example.seconds, example.exit_code})) {
    return report(*std::move(wrong));
  }
  ExampleResult result{shown, std::move(outcome.out),
                       records_in(records, code, example, lesson, diagnostics), seconds,
                       std::move(files)};
  result.page = run_in_page(example, code.text, result, worker_context);
  return result;
}

}  // namespace mjcourse
