#include "evaluate/example.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <regex>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/temporary_folder.h"
#include "evaluate/compile_errors.h"
#include "evaluate/records.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostRecords = 16 << 20;  // bytes

// The last lines of what a program wrote, for a person to see why it ended.
std::string tail(std::string_view text) {
  constexpr int lines = 8;
  const std::size_t last = text.find_last_not_of(" \n");
  text = text.substr(0, last == text.npos ? 0 : last + 1);
  std::size_t begin = text.size();
  for (int n = 0; n < lines && begin != text.npos && begin > 0; ++n) {
    begin = text.rfind('\n', begin - 1);
  }
  text = begin == text.npos ? text : text.substr(begin);
  return std::string(text.substr(std::min(text.find_first_not_of('\n'), text.size())));
}

// What an uncaught exception left on stderr: "std::runtime_error: no such model", and the lines of
// its what() behind the first.
struct UncaughtException {
  std::string first_line, more;
};
std::optional<UncaughtException> find_uncaught_exception(const std::string& err) {
  static const std::regex form(
      R"(terminate called after throwing an instance of '([^']*)'(?:\s+what\(\):\s*([^\n]*)\n?)?)");
  std::smatch part;
  if (!std::regex_search(err, part, form)) return std::nullopt;
  return UncaughtException{part[1].str() + (part[2].matched ? ": " + part[2].str() : ""),
                           part.suffix()};
}

std::string seconds_text(double seconds) {
  std::ostringstream text;
  text << seconds << " s";
  return text.str();
}

// What went wrong in a run, if anything did.
std::optional<Diagnostic> judge(const Outcome& outcome, const Example& example) {
  Diagnostic found;
  switch (outcome.end) {
    case Outcome::End::exited:
      if (outcome.code == 0) return std::nullopt;
      found.id = "E-example-exit";
      found.message = "the program exited with code " + std::to_string(outcome.code);
      break;
    case Outcome::End::killed_by_signal:
      found.id = "E-example-signal";
      found.message = std::string("the program was killed: ") + strsignal(outcome.code);
      if (const auto thrown = find_uncaught_exception(outcome.err)) {
        found.id = "E-example-throws";
        found.message = "the program threw " + thrown->first_line;
        found.detail = tail(thrown->more);
        found.cure = "catch it, or mend what it complains about";
        return found;
      }
      break;
    case Outcome::End::timed_out:
      found.id = "E-example-timeout";
      found.message =
          "the program still ran after " + seconds_text(example.seconds) + ", and was stopped";
      found.cure =
          "look for a loop without an end; a program that needs longer says `timeout=SECONDS`";
      break;
    case Outcome::End::flooded:
      found.id = "E-example-flood";
      found.message = "the program printed more than 1 MiB, and was stopped";
      found.cure = "print what a reader wants to read";
      return found;
    case Outcome::End::not_started:
      found.id = "E-example-signal";
      found.message = std::string("the program could not be started: ") + strerror(outcome.code);
      break;
  }
  found.detail = tail(outcome.err);
  return found;
}

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

}  // namespace

std::optional<ExampleResult> evaluate_example(const Example& example, const Lesson& lesson,
                                              const fs::path& root, const Compiler& compiler,
                                              Diagnostics& diagnostics) {
  const std::optional<LocatedText> code = code_of(example, lesson, root, diagnostics);
  if (!code) return std::nullopt;
  const TemporaryFolder folder;
  const std::string shown_as = code->offsets.empty() ? example.file.text : lesson.source->path();
  const int first_line =
      code->offsets.empty() ? 1 : lesson.source->position(code->span(0, 0).begin).line;
  const fs::path source = folder.path() / (example.name() + ".cpp");
  const fs::path binary = folder.path() / example.name();
  write_file(source,
             "#line " + std::to_string(first_line) + " \"" + shown_as + "\"\n" + code->text);

  const Compiled compiled = compiler.compile(source, root / "examples", binary, folder.path());
  report_compile_messages(compiled, {*code, first_line, shown_as, example.span}, lesson,
                          diagnostics);
  if (!compiled.succeeded) return std::nullopt;

  Command command;
  command.arguments = {binary.string()};
  command.folder = folder.path() / "run";
  fs::create_directory(command.folder);
  const fs::path records = folder.path() / "records";
  command.environment = {"MJCOURSE_MODELS=" + fs::absolute(root / "models").string(),
                         "MJCOURSE_RECORDS=" + fs::absolute(records).string()};
  command.seconds = example.seconds;
  Outcome outcome = run(command);
  if (std::optional<Diagnostic> wrong = judge(outcome, example)) {
    wrong->place = place_of(*lesson.source, example.span);
    diagnostics.push_back(std::move(*wrong));
    return std::nullopt;
  }
  return ExampleResult{code->text, std::move(outcome.out),
                       records_in(records, *code, example, lesson, diagnostics)};
}

}  // namespace mjcourse
