#include "evaluate/compiler.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace mjcourse {
namespace {

const std::vector<std::string> kFlags{
    "-std=c++20", "-Wall", "-Wextra", "-fno-diagnostics-color", "-isystem", "/usr/include/eigen3"};
constexpr double kSeconds = 120;

std::vector<CompilerMessage> parse(const std::string& text) {
  static const std::regex form(R"(^(.+?):(\d+):(\d+): (error|fatal error|warning|note): (.*)$)");
  std::vector<CompilerMessage> messages;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch part;
    // A line of kilobytes is code that a template printed, and std::regex recurses over it.
    if (line.size() > 4000 || !std::regex_match(line, part, form)) continue;
    messages.push_back({part[1], std::stoi(part[2]), std::stoi(part[3]), part[4], part[5]});
  }
  return messages;
}

// "clang 16.0.6" of what `NAME --version` prints: "Debian clang version 16.0.6 (15~deb12u1)".
std::string short_version(const std::string& name, const std::string& printed) {
  static const std::regex form(R"(\d+\.\d+(\.\d+)?)");
  std::smatch part;
  const std::string first = printed.substr(0, printed.find('\n'));
  const std::string number = std::regex_search(first, part, form) ? part[0].str() : "";
  const std::string plain = name.starts_with("clang") ? "clang" : name;
  return number.empty() ? plain : plain + " " + number;
}

}  // namespace

bool Compiled::refused() const {
  return !succeeded && std::any_of(messages.begin(), messages.end(), [](const auto& message) {
    return message.severity == "error" || message.severity == "fatal error";
  });
}

std::optional<Compiler> Compiler::find() {
  for (const char* name : {"clang++-16", "clang++-14", "clang++", "g++"}) {
    Command command;
    command.arguments = {name, "--version"};
    const Outcome outcome = run(command);
    if (outcome.end == Outcome::End::exited) {
      return Compiler(name, short_version(name, outcome.out));
    }
  }
  return std::nullopt;
}

Compiled Compiler::compile(const std::filesystem::path& source,
                           const std::filesystem::path& examples,
                           const std::filesystem::path& binary, const std::filesystem::path& folder,
                           bool optimize) const {
  Command command;
  // Optimising mostly costs more than it saves: MuJoCo itself is optimised, and gives the same bits
  // however its caller was compiled.
  command.arguments = {name_, optimize ? "-O2" : "-O0"};
  command.arguments.insert(command.arguments.end(), kFlags.begin(), kFlags.end());
  const std::filesystem::path include = examples / "include";
  command.arguments.insert(command.arguments.end(),
                           {"-I" + include.string(), source.string(), "-o", binary.string()});
  // The handlers keep MuJoCo's errors from waiting on stdin; a course may do without the helper.
  const std::filesystem::path handlers = include / "mjcourse" / "handlers.cpp";
  if (std::filesystem::exists(handlers)) command.arguments.push_back(handlers.string());
  command.arguments.push_back("-lmujoco");
  command.folder = folder.string();
  command.environment = {"TMPDIR=" + folder.string()};  // a compiler that is killed leaves files
  command.seconds = kSeconds;
  const Outcome outcome = run(command);

  Compiled compiled;
  compiled.raw = outcome.err;
  if (outcome.end == Outcome::End::timed_out) compiled.raw += "\nthe compiler ran out of time";
  compiled.succeeded = outcome.end == Outcome::End::exited && outcome.code == 0;
  compiled.messages = parse(outcome.err);
  return compiled;
}

}  // namespace mjcourse
