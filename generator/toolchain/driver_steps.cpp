#include "toolchain/driver_steps.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <sstream>
#include <string_view>

#include "toolchain/toolchain.h"

namespace mjcourse {
namespace {

using Words = std::vector<std::string>;

Words parse_words(std::string_view line) {
  Words words;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      quoted = !quoted;
      if (quoted) words.emplace_back();
    } else if (quoted) {
      if (line[i] == '\\' && i + 1 < line.size()) ++i;
      words.back() += line[i];
    }
  }
  return words;
}

// Which of the names stands at `at`; the longest, as "a" begins "a.cpp". Their number when none.
std::size_t name_at(std::string_view word, std::size_t at, const Words& names) {
  std::size_t found = names.size();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool longer = found == names.size() || names[i].size() > names[found].size();
    if (longer && !names[i].empty() && word.substr(at).starts_with(names[i])) found = i;
  }
  return found;
}

std::string shell_word(std::string_view word, const Words& names) {
  std::string text = "'";
  for (std::size_t at = 0; at < word.size();) {
    if (const std::size_t name = name_at(word, at, names); name < names.size()) {
      text += "'\"$" + std::to_string(name + 1) + "\"'";
      at += names[name].size();
    } else {
      text += word[at] == '\'' ? "'\\''" : std::string(1, word[at]);
      ++at;
    }
  }
  return text + "'";
}

// The driver's script; empty where it does not tell.
std::string ask(Words command, const Words& names, const std::filesystem::path& folder,
                const std::vector<std::filesystem::path>& reads) {
  command.emplace_back("-###");
  const Outcome outcome = run_tool(std::move(command), folder, reads);
  return succeeded(outcome) ? shell_script(parse_driver_steps(outcome.err), names) : "";
}

}  // namespace

std::vector<Words> parse_driver_steps(const std::string& text) {
  std::vector<Words> steps;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(" \"")) steps.push_back(parse_words(line));
  }
  return steps;
}

std::string shell_script(const std::vector<Words>& commands, const Words& names) {
  std::string script;
  for (const Words& command : commands) {
    if (!script.empty()) script += " &&\n";
    for (const std::string& word : command) {
      script += (&word == &command.front() ? "" : " ") + shell_word(word, names);
    }
  }
  return script;
}

Words without_driver(const Words& command, const Words& names, const std::filesystem::path& folder,
                     const std::vector<std::filesystem::path>& reads) {
  static std::mutex mutex;
  static std::map<std::string, std::string> known;  // scripts of steps, by that of the command
  const std::string asked = shell_script({command}, names);
  std::string script;
  {
    const std::lock_guard lock(mutex);
    auto found = known.find(asked);
    if (found == known.end()) {
      found = known.emplace(asked, ask(command, names, folder, reads)).first;
    }
    script = found->second;
  }
  if (script.empty()) return command;
  Words shell{"sh", "-c", script, "sh"};
  shell.insert(shell.end(), names.begin(), names.end());
  return shell;
}

}  // namespace mjcourse
