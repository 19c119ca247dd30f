#include "toolchain/compiler_output.h"

#include <re2/re2.h>

#include <algorithm>
#include <sstream>

namespace mjcourse {

std::vector<CompilerMessage> parse_messages(const std::string& said) {
  // Whatever bytes the compiler quotes.
  static const RE2 form(R"((.+?):(\d+):(\d+): (error|fatal error|warning|note): (.*))",
                        RE2::Latin1);
  std::vector<CompilerMessage> messages;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    CompilerMessage message;
    const bool is_message = RE2::FullMatch(line, form, &message.file, &message.line,
                                           &message.column, &message.severity, &message.text);
    if (is_message) messages.push_back(std::move(message));
  }
  return messages;
}

std::vector<std::string> parse_dependencies(std::string_view rule,
                                            const std::filesystem::path& folder) {
  const std::string own = folder.lexically_normal().string() + "/";
  std::vector<std::string> files;
  std::string word;
  const auto finish = [&] {
    if (word.empty()) return;
    std::string path = (folder / word).lexically_normal().string();
    word.clear();
    if (!path.starts_with(own)) files.push_back(std::move(path));
  };
  // The target ends with a colon before a blank; a path may have a colon inside of it.
  rule.remove_prefix(std::min(rule.find(": "), rule.size() - 1) + 1);
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const char next = i + 1 < rule.size() ? rule[i + 1] : '\n';
    const bool escapes =
        rule[i] == '\\' ? next == ' ' || next == '#' : rule[i] == '$' && next == '$';
    if (escapes) {
      word += rule[++i];
    } else if (rule[i] == '\\' && next == '\n') {
      ++i;
      finish();
    } else if (rule[i] == ' ' || rule[i] == '\n') {
      finish();
    } else {
      word += rule[i];
    }
  }
  finish();
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

}  // namespace mjcourse
