#include "evaluate/compiler_output.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace mjcourse {

std::vector<CompilerMessage> parse_messages(const std::string& said) {
  static const std::regex form(R"(^(.+?):(\d+):(\d+): (error|fatal error|warning|note): (.*)$)");
  std::vector<CompilerMessage> messages;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    std::smatch part;
    // A line of kilobytes is code that a template printed, and std::regex recurses over it.
    if (line.size() > 4000 || !std::regex_match(line, part, form)) continue;
    messages.push_back({part[1], std::stoi(part[2]), std::stoi(part[3]), part[4], part[5]});
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
