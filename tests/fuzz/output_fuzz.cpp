// An output as a lesson states it, held against what its program printed, and accepted.
//
// The input: a line with words of what the output stands in (quote, list, crlf, long, tol), what is
// stated, a line `=====`, what was printed.
#include <algorithm>
#include <cctype>
#include <vector>

#include "base/text_lines.h"
#include "base/utf8.h"
#include "evaluate/programs/output_diff.h"
#include "evaluate/programs/output_edit.h"
#include "fuzz.h"
#include "lesson/read_lesson.h"
#include "report/diff_text.h"
#include "require.h"

namespace mjcourse {
namespace {

struct Input {
  std::string words, stated, printed;

  bool has(const char* word) const { return words.find(word) != words.npos; }
};

Input input_of(const std::string& bytes) {
  const std::string between = "=====\n";
  const std::size_t first = std::min(bytes.find('\n'), bytes.size());
  const std::size_t stated = std::min(first + 1, bytes.size());
  const std::size_t middle = std::min(bytes.find(between, stated), bytes.size());
  const std::size_t printed = std::min(middle + between.size(), bytes.size());
  return {bytes.substr(0, first), bytes.substr(stated, middle - stated), bytes.substr(printed)};
}

// What judging a program's run lets pass.
bool is_text(const std::string& printed) {
  if (find_invalid_utf8(printed)) return false;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const bool line_end = printed[i] == '\r' && i + 1 < printed.size() && printed[i + 1] == '\n';
    const bool plain = printed[i] == '\n' || printed[i] == '\t' || line_end;
    if (std::iscntrl(static_cast<unsigned char>(printed[i])) != 0 && !plain) return false;
  }
  return true;
}

std::string lesson_of(const Input& input) {
  const std::string fence(input.has("long") ? 5 : 3, '`');
  std::string body = "```cpp file=examples/x.cpp\nint main() {}\n```\n\n";
  body += fence + "text" + (input.has("tol") ? " tol=0.5" : "") + "\n" + input.stated;
  body += (input.stated.empty() || input.stated.ends_with('\n') ? "" : "\n") + fence + "\n";
  std::string text = "---\ntitle: T\n---\n";
  bool first = true;
  for (const std::string_view line : lines_of(body)) {
    if (input.has("quote")) text += "> ";
    if (input.has("list")) text += first ? "- " : "  ";
    text += std::string(line) + (input.has("crlf") ? "\r\n" : "\n");
    first = false;
  }
  return text + "\nThe end.\n";
}

// The lesson's only output; null where it has mistakes or other outputs, which is no case.
const Output* only_output(const std::optional<Lesson>& lesson, const Diagnostics& diagnostics) {
  const Output* only = nullptr;
  if (!lesson || !diagnostics.empty()) return nullptr;
  for (const Block& block : lesson->blocks) {
    const auto* output = std::get_if<Output>(&block);
    if (output != nullptr && only != nullptr) return nullptr;
    if (output != nullptr) only = output;
  }
  return only;
}

// A line that goes is the lesson's own; and the lines that stay agree with those printed between
// the ones that come.
void check_changes(const std::vector<DiffLine>& changes, const std::string& stated,
                   const std::string& printed, std::optional<double> tolerance) {
  std::vector<std::string_view> before = lines_of(stated), after = lines_of(printed);
  const auto is_blank = [](std::string_view line) { return trimmed(line).empty(); };
  while (!before.empty() && is_blank(before.back())) before.pop_back();
  while (!after.empty() && is_blank(after.back())) after.pop_back();
  std::size_t at = 0;
  auto change = changes.begin();
  for (std::size_t i = 0; i <= before.size(); ++i) {
    bool gone = false;
    for (; change != changes.end() && change->line == static_cast<int>(i) + 1; ++change) {
      if (change->kind == DiffLine::Kind::gone) {
        gone = true;
        continue;
      }
      require(at < after.size() && after[at].starts_with(change->text), "what comes was printed");
      ++at;
    }
    if (gone || i == before.size()) continue;
    Retrials retrials;
    require(at < after.size() && lines_agree(before[i], after[at], tolerance, retrials),
            "what stays agrees");
    ++at;
  }
  require(change == changes.end() && at == after.size(), "every line is accounted for");
}

void check_output(const Input& input) {
  if (!is_text(input.printed)) return;
  Retrials retrials;
  require(output_changes(input.printed, input.printed, std::nullopt, retrials).empty(),
          "a text is itself");
  const std::string path = "content/1-a/1.1-x.md", bytes = lesson_of(input);
  Diagnostics diagnostics;
  const std::optional<Lesson> lesson = read_lesson(path, bytes, diagnostics);
  const Output* output = only_output(lesson, diagnostics);
  if (output == nullptr) return;
  const std::optional<double> tolerance = output->tolerance;
  const auto changes = output_changes(output->text.text, input.printed, tolerance, retrials);
  check_changes(changes, output->text.text, input.printed, tolerance);
  if (changes.empty()) return;
  diff_text(changes, [&](std::string_view stated, std::string_view printed) {
    return lines_agree(stated, printed, tolerance, retrials);
  });

  const Edit edit = output_edit(*output, changes, *lesson);
  const Span span = edit.span.value();
  require(span.begin <= span.end && span.end <= bytes.size(), "the edit is in the file");
  const std::string accepted = bytes.substr(0, span.begin) + edit.text + bytes.substr(span.end);
  Diagnostics found;
  const std::optional<Lesson> again = read_lesson(path, accepted, found);
  const Output* mended = only_output(again, found);
  require(mended != nullptr, "what was accepted is a lesson with one output:\n" + accepted);
  require(output_changes(mended->text.text, input.printed, tolerance, retrials).empty(),
          "what was accepted agrees:\n" + accepted);
  require(again->blocks.size() == lesson->blocks.size(), "nothing else changed");
}

}  // namespace
}  // namespace mjcourse

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mjcourse::check_output(mjcourse::input_of(mjcourse::text_of_input(data, size)));
  return 0;
}
