// What a compiler leaves besides its object: what it said, and the list of the files it read.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

// What the compiler said about one place.
struct CompilerMessage {
  std::string file;  // as the compiler names it: what `#line` said, or a header's path
  int line = 0, column = 0;
  std::string severity;  // "error", "fatal error", "warning", "note"
  std::string text;
};

std::vector<CompilerMessage> parse_messages(const std::string& said);

// The files of a rule of make, as `-MD` writes them, but for those in `folder`: absolute paths
// without detours, sorted.
std::vector<std::string> parse_dependencies(std::string_view rule,
                                            const std::filesystem::path& folder);

}  // namespace mjcourse
