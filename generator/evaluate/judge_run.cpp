#include "evaluate/judge_run.h"

#include <algorithm>
#include <cstring>
#include <regex>
#include <sstream>
#include <string_view>

#include "base/utf8.h"

namespace mjcourse {
namespace {

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
  }
  found.detail = tail(outcome.err);
  return found;
}

// Is this a control character that no text holds? A carriage return may end a line.
bool is_control(std::string_view text, std::size_t at) {
  const auto byte = static_cast<unsigned char>(text[at]);
  if (byte == '\r') return at + 1 < text.size() && text[at + 1] != '\n';
  return (byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7F;
}

// Neither a page nor a lesson can hold what is no text.
std::optional<Diagnostic> judge_text(const std::string& out, const ExpectedRun& expected) {
  std::size_t at = 0;
  while (at < out.size() && !is_control(out, at)) ++at;
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

Diagnostic killed(const Outcome& outcome, const ExpectedRun& expected) {
  Diagnostic found;
  if (const auto thrown = find_uncaught_exception(outcome.err)) {
    found.id = "E-example-throws";
    found.message = "the " + expected.what + " threw " + thrown->first_line;
    found.detail = tail(thrown->more);
    found.cure = "catch it, or mend what it complains about";
    return found;
  }
  found.id = "E-example-signal";
  found.message = "the " + expected.what + " was killed: " + strsignal(outcome.code);
  found.detail = tail(outcome.err);
  return found;
}

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
      found.message = "the " + expected.what + " printed more than 1 MiB, and was stopped";
      found.cure = "print what a reader wants to read";
      break;
    case Outcome::End::not_started:
      found.id = "E-example-signal";
      found.message = "the " + expected.what + " could not be started: " + strerror(outcome.code);
      break;
  }
  return found;
}

}  // namespace mjcourse
