#include "toolchain/raw_tokens.h"

#include <charconv>
#include <optional>
#include <utility>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "toolchain/containment.h"

namespace mjcourse {
namespace {

constexpr double kSeconds = 60;
// A line of the list has some forty bytes beside its token.
constexpr std::size_t kMostListed = 256 << 20;

std::vector<std::size_t> line_starts(std::string_view text) {
  std::vector<std::size_t> starts{0};
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') starts.push_back(i + 1);
  }
  return starts;
}

// The number that `text` begins with, which goes.
std::optional<std::size_t> take_number(std::string_view& text, char behind) {
  std::size_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (text.empty() || text[0] != behind) return std::nullopt;
  text.remove_prefix(1);
  return number;
}

// Reads the list of the tokens of one file, `KIND 'TEXT'\t[FLAGS]\tLoc=<PATH:LINE:COLUMN>` each. A
// token may have lines, and these may look like a list: but the path is one that nobody knows
// before. Takes what it reads from `list`; nothing where that is no such list of the whole text.
std::optional<RawTokens> tokens_in(std::string_view& list, const std::string& path,
                                   std::string_view text) {
  const std::string place = "\tLoc=<" + path + ":";
  const std::vector<std::size_t> lines = line_starts(text);
  RawTokens tokens;
  for (std::size_t at; (at = list.find(place)) != list.npos;) {
    std::string kind(list.substr(0, list.find(' ')));
    list.remove_prefix(at + place.size());
    const auto line = take_number(list, ':');
    const auto column = line ? take_number(list, '>') : std::nullopt;
    if (!column || *line == 0 || *line > lines.size() || !list.starts_with('\n')) {
      return std::nullopt;
    }
    list.remove_prefix(1);
    const std::size_t begin = lines[*line - 1] + *column - 1;
    if (begin >= text.size() || (tokens.empty() ? begin > 0 : begin <= tokens.back().begin)) {
      return std::nullopt;
    }
    if (!tokens.empty()) tokens.back().end = begin;
    tokens.push_back({std::move(kind), begin, text.size()});
  }
  return tokens;
}

}  // namespace

tl::expected<std::vector<RawTokens>, std::string> raw_tokens(const std::vector<std::string>& texts,
                                                             const Toolchain& toolchain) {
  if (!toolchain.is_clang()) {
    return tl::unexpected("only clang tells the tokens of a text, and the compiler here is " +
                          toolchain.version);
  }
  const TemporaryFolder folder;
  Command command;
  command.arguments = {toolchain.compiler, "-fsyntax-only",   "-std=c++20", "-w",
                       "-Xclang",          "-dump-raw-tokens"};
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    paths.push_back(folder.path() / (std::to_string(i) + ".cpp"));
    write_file(paths.back(), texts[i]);
  }
  command.arguments.insert(command.arguments.end(), paths.begin(), paths.end());
  command.folder = folder.path();
  command.seconds = kSeconds;
  command.output_bytes = kMostListed;
  command.sandbox = compiler_sandbox(folder.path(), {});
  const Outcome outcome = run(command);
  if (!succeeded(outcome)) return tl::unexpected(std::string("the lexer gave no answer"));
  std::string_view list = outcome.err;
  std::vector<RawTokens> all;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    auto tokens = tokens_in(list, paths[i], texts[i]);
    if (!tokens || (tokens->empty() && !texts[i].empty())) {
      return tl::unexpected(std::string("the lexer's answer is not understood"));
    }
    all.push_back(*std::move(tokens));
  }
  return all;
}

}  // namespace mjcourse
