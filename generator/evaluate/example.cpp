#include "evaluate/example.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/stopwatch.h"
#include "base/temporary_folder.h"
#include "evaluate/compile_errors.h"
#include "evaluate/judge_run.h"
#include "evaluate/records.h"
#include "evaluate/region.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostRecords = 16 << 20;  // bytes

// The code of an example: its fence's, or the file's where the fence is empty. Both must agree.
std::optional<LocatedText> code_of(const Example& example, const Lesson& lesson,
                                   const fs::path& root, Diagnostics& diagnostics) {
  const std::string& path = example.file.text;
  const auto file = DiskFiles(root).read(path);
  if (example.code.text.empty() && file) return LocatedText{*file, {}};
  if (file && *file == example.code.text) return example.code;
  Diagnostic found = error_at(place_of(*lesson.source, example.file.span()), "E-example-file", "");
  if (!file) {
    found.message = "cannot read " + file.error();
    found.cure = "save the fence's text as " + path;
  } else {
    const auto [ours, theirs] = std::mismatch(example.code.text.begin(), example.code.text.end(),
                                              file->begin(), file->end());
    const auto line = 1 + std::count(example.code.text.begin(), ours, '\n');
    const auto at = static_cast<std::size_t>(ours - example.code.text.begin());
    found.message = "the fence and " + path + " differ, first in line " + std::to_string(line);
    found.notes.push_back(
        {"the lesson has", place_of(*lesson.source, example.code.span(at, at + 1))});
    const SourceText source(path, *file);
    const auto there = static_cast<std::size_t>(theirs - file->begin());
    found.notes.push_back({"the file has", place_of(source, {there, there + 1})});
    found.cure =
        "make them the same text: the fence is what a reader sees, the file what a learner builds";
  }
  diagnostics.push_back(std::move(found));
  // What the lesson shows is still worth compiling.
  return example.code.text.empty() ? std::nullopt : std::optional(example.code);
}

// What the program wrote into `file` for its lesson; a fault is shown where the code names the
// record.
Records records_in(const fs::path& file, const LocatedText& code, const Example& example,
                   const Lesson& lesson, Diagnostics& diagnostics) {
  if (!fs::exists(file)) return {};
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

// The command line that runs `binary` in an empty folder inside `folder`; what it reports goes into
// the file `records`.
Command run_command(const Example& example, const fs::path& binary, const fs::path& folder,
                    const fs::path& root, const fs::path& records) {
  Command command;
  command.arguments = {binary.string()};
  command.arguments.insert(command.arguments.end(), example.arguments.begin(),
                           example.arguments.end());
  command.folder = folder / "run";
  fs::create_directory(command.folder);
  command.environment = {"MJCOURSE_MODELS=" + fs::absolute(root / "models").string(),
                         "MJCOURSE_RECORDS=" + fs::absolute(records).string()};
  command.seconds = example.seconds;
  return command;
}

}  // namespace

std::optional<ExampleResult> evaluate_example(const Example& example, const Lesson& lesson,
                                              const fs::path& root, const Compiler& compiler,
                                              Diagnostics& diagnostics) {
  const std::optional<LocatedText> code = code_of(example, lesson, root, diagnostics);
  if (!code) return std::nullopt;
  const std::string shown = without_region_marks(code->text);
  const TemporaryFolder folder;
  // The refusal that a page shows is what a learner sees who builds the file.
  const bool in_file = code->offsets.empty() || !example.compiles;
  const std::string shown_as = in_file ? example.file.text : lesson.source->path();
  const int first_line = in_file ? 1 : lesson.source->position(code->span(0, 0).begin).line;
  const fs::path source = folder.path() / (example.name() + ".cpp");
  const fs::path binary = folder.path() / example.name();
  write_file(source,
             "#line " + std::to_string(first_line) + " \"" + shown_as + "\"\n" + code->text);

  const Compiled compiled =
      compiler.compile(source, root / "examples", binary, folder.path(), example.optimize);
  if (!example.compiles && compiled.refused()) {
    return ExampleResult{shown,
                         without_folders(compiled.raw, {fs::absolute(root), root, folder.path()})};
  }
  report_compile_messages(compiled, {*code, first_line, shown_as, example.span}, lesson,
                          diagnostics);
  if (!compiled.succeeded) return std::nullopt;
  const auto report = [&](Diagnostic wrong) {
    wrong.place = place_of(*lesson.source, example.span);
    diagnostics.push_back(std::move(wrong));
    return std::nullopt;
  };
  if (!example.compiles) {
    return report(error_at({}, "E-example-compiles", "the program compiles, and is said not to",
                           "remove `expect=compile-error`, or mend the lesson's point"));
  }
  const fs::path records = folder.path() / "records";
  const Stopwatch stopwatch;
  Outcome outcome = run(run_command(example, binary, folder.path(), root, records));
  const double seconds = stopwatch.seconds();
  if (auto wrong = judge_run(outcome, {"program", example.seconds, example.exit_code})) {
    return report(*std::move(wrong));
  }
  return ExampleResult{shown, std::move(outcome.out),
                       records_in(records, *code, example, lesson, diagnostics), seconds};
}

}  // namespace mjcourse
