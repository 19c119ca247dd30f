#include "evaluate/programs/judge_run.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <sstream>
#include <string_view>
#include <vector>

#include "base/text_lines.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

// The last lines of what a program wrote, for a person to see why it ended.
std::string tail(std::string_view text) {
  constexpr std::size_t most = 8;
  const std::size_t last = text.find_last_not_of(" \n");
  const std::vector<std::string_view> lines =
      lines_of(text.substr(0, last == text.npos ? 0 : last + 1));
  std::string shown_lines;
  for (std::size_t i = lines.size() - std::min(most, lines.size()); i < lines.size(); ++i) {
    if (shown_lines.empty() && lines[i].empty()) continue;
    shown_lines += (shown_lines.empty() ? "" : "\n") + readable_output(lines[i]);
  }
  return shown_lines;
}

// What an uncaught exception left on stderr: "std::runtime_error: no such model", and the lines of
// its what() behind the first.
struct UncaughtException {
  std::string first_line;
  std::string_view more;
};
std::optional<UncaughtException> find_uncaught_exception(std::string_view err) {
  constexpr std::string_view start = "terminate called after throwing an instance of '";
  constexpr std::string_view before_what = "'\n  what():  ";
  const std::size_t at = err.find(start);
  if (at == err.npos) return std::nullopt;
  err.remove_prefix(at + start.size());
  const std::size_t type_end = err.find('\'');
  if (type_end == err.npos) return std::nullopt;
  const std::string type = readable_output(err.substr(0, type_end));
  err.remove_prefix(type_end);
  if (!err.starts_with(before_what)) return UncaughtException{type, err.substr(1)};
  err.remove_prefix(before_what.size());
  const std::size_t end = std::min(err.find('\n'), err.size());
  return UncaughtException{type + ": " + readable_output(err.substr(0, end)), err.substr(end)};
}

// What MuJoCo said when it ended the run, as examples/include/mjcourse/handlers.cpp and the program
// of the snippets have it say: on the last line, with this code. Empty where it did not.
std::string find_mujoco_error(const Outcome& outcome) {
  constexpr int code = 70;
  constexpr std::string_view start = "MuJoCo error: ";
  const std::string last = tail(outcome.err);
  const std::size_t at = last.rfind(start);
  return outcome.code == code && at != last.npos ? last.substr(at + start.size()) : "";
}

std::string seconds_text(double seconds) {
  std::ostringstream text;
  text << seconds << " s";
  return text.str();
}

// An exit with another code than the expected one.
Diagnostic wrong_exit(const Outcome& outcome, const ExpectedRun& expected) {
  Diagnostic found;
  if (const std::string error = find_mujoco_error(outcome); !error.empty()) {
    found.id = "E-example-mujoco";
    found.message = "MuJoCo stopped the " + expected.what + ": " + error;
    return found;
  }
  found.id = "E-example-exit";
  found.message = "the " + expected.what + " exited with code " + std::to_string(outcome.code);
  if (expected.exit_code != 0) {
    found.message += ", and " + std::to_string(expected.exit_code) + " was expected";
    found.cure = outcome.code == 0
                     ? "mend the program, or leave `expect` out if 0 is right"
                     : "mend the program, or write `expect=exit:" + std::to_string(outcome.code) +
                           "` if that is right";
  }
  found.detail = tail(outcome.err);
  return found;
}

// Neither a page nor a lesson can hold what is no text.
std::optional<Diagnostic> judge_text(const std::string& out, const ExpectedRun& expected) {
  const std::size_t at = find_control_character(out).value_or(out.size());
  const std::size_t invalid = find_invalid_utf8(out).value_or(out.size());
  if (std::min(at, invalid) == out.size()) return std::nullopt;
  const auto first = static_cast<std::ptrdiff_t>(std::min(at, invalid));
  constexpr std::string_view hex = "0123456789ABCDEF";
  const auto byte = static_cast<unsigned char>(out[static_cast<std::size_t>(first)]);
  Diagnostic found;
  found.id = "E-example-text";
  found.message = "the " + expected.what + " printed the byte 0x" +
                  std::string{hex[byte >> 4], hex[byte & 15]} + " in line " +
                  std::to_string(1 + std::count(out.begin(), out.begin() + first, '\n')) +
                  (invalid <= at ? ", which is not UTF-8" : ", a control character");
  found.cure = "print plain text in UTF-8, without colours and without overwriting a line";
  return found;
}

// "128 MiB"
std::string size_in_words(std::uint64_t bytes) {
  const bool large = bytes % (1 << 30) == 0;
  return std::to_string(bytes >> (large ? 30 : 20)) + (large ? " GiB" : " MiB");
}

Diagnostic killed(const Outcome& outcome, const ExpectedRun& expected) {
  Diagnostic found;
  if (const auto thrown = find_uncaught_exception(outcome.err)) {
    found.id = "E-example-throws";
    found.message = "the " + expected.what + " threw " + thrown->first_line;
    found.detail = tail(thrown->more);
    found.cure = "catch it, or fix what it complains about";
    return found;
  }
  found.id = "E-example-signal";
  found.message = "the " + expected.what + " was killed: " + strsignal(outcome.code);
  found.detail = tail(outcome.err);
  if (outcome.code == SIGILL) {
    found.cure = "look for a function that comes to its end without the `return` of its value";
  }
  if (outcome.code == SIGXFSZ) {
    found.cure =
        "a file of a " + expected.what + " may be " + size_in_words(expected.sandbox.file_bytes);
  }
  return found;
}

constexpr std::size_t kMostPrinted = (1 << 20) - 1;

}  // namespace

std::optional<Diagnostic> judge_run(const Outcome& outcome, const ExpectedRun& expected) {
  Diagnostic found;
  switch (outcome.end) {
    case Outcome::End::exited:
      if (outcome.code == expected.exit_code) return judge_text(outcome.out, expected);
      return wrong_exit(outcome, expected);
    case Outcome::End::killed_by_signal:
      return killed(outcome, expected);
    case Outcome::End::timed_out:
      found.id = "E-example-timeout";
      found.message = "the " + expected.what + " still ran after " +
                      seconds_text(expected.seconds) + ", and was stopped";
      found.cure = "look for a loop without an end; a " + expected.what +
                   " that needs longer says `timeout=SECONDS`";
      found.detail = tail(outcome.err);
      break;
    case Outcome::End::flooded:
      found.id = "E-example-flood";
      found.message = "the " + expected.what +
                      (outcome.out.size() + outcome.err.size() > kMostPrinted
                           ? " printed more than 1 MiB, and was stopped"
                           : " reported more than 16 MiB, and was stopped");
      found.cure = "print what a reader wants to read";
      break;
    case Outcome::End::refused:
      found.id = "E-example-refused";
      found.message =
          "the " + expected.what + " tried to " + readable(outcome.refused) + ", and was stopped";
      found.cure =
          "a " + expected.what +
          " can read the course's models, write into the folder that it runs in, and start "
          "threads";
      found.detail = tail(outcome.err);
      break;
    case Outcome::End::overfilled:
      found.id = "E-example-disk";
      found.message = "the " + expected.what + " wrote too many files, and was stopped";
      found.cure = "all files of a " + expected.what + " may be " +
                   size_in_words(expected.sandbox.folder_bytes) + " and " +
                   std::to_string(expected.sandbox.folder_entries) + " in number";
      break;
    case Outcome::End::exhausted:
      found.id = "E-example-memory";
      found.message = "the " + expected.what +
                      " took more than 4 GiB of memory with all that it started, and was stopped";
      found.cure = "start fewer processes at once, or smaller ones";
      found.detail = tail(outcome.err);
      break;
    case Outcome::End::not_started:
      found.id = "E-example-signal";
      found.message = "the " + expected.what + " could not be started: " + strerror(outcome.code);
      break;
  }
  return found;
}

}  // namespace mjcourse
