#include "course/last_changed.h"

#include <re2/re2.h>

#include <optional>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "course/git.h"

namespace mjcourse {

namespace {

constexpr std::string_view kNoCommits = "does not have any commits yet";
constexpr const char* kOfShallow =
    "this is a shallow clone, in which git knows no dates; `git fetch --unshallow` brings the "
    "rest, "
    "and so does `fetch-depth: 0` of actions/checkout";

bool is_day(const std::string& text) {
  static const RE2 form(R"(\d{4}-(?:0[1-9]|1[0-2])-(?:0[1-9]|[12]\d|3[01]))");
  return RE2::FullMatch(text, form);
}

// The newest commit comes first: its day and time, then the files that it changed.
LastChanges changes_of(const std::string& text) {
  LastChanges changes;
  std::istringstream log(text);
  LastChange change;
  for (std::string line; std::getline(log, line);) {
    if (line.starts_with('\x01')) {
      const std::size_t space = line.find(' ');
      change = {line.substr(1, space - 1), line.substr(space + 1)};
      if (!is_day(change.day)) change = {};  // git takes any number for a time
    } else if (!line.empty()) {
      changes.try_emplace(line, change);
    }
  }
  return changes;
}

}  // namespace

History last_changed(const std::filesystem::path& root, const std::string& folder) {
  const std::optional<Git> git = Git::find(root);
  if (!git) return {};
  const auto shallow = git->ask({"rev-parse", "--is-shallow-repository"});
  if (!shallow) return {{}, shallow.error()};
  // The commit at which a shallow clone ends looks as if it had made all files.
  if (*shallow != "false\n") return {{}, kOfShallow};
  const auto log = git->ask({"log", "--no-ext-diff", "--no-textconv", "--format=%x01%cs %cd",
                             "--date=format-local:%Y-%m-%dT%H:%M:%SZ", "--name-only", "--relative",
                             "--", folder});
  if (!log) return {{}, log.error().find(kNoCommits) == std::string::npos ? log.error() : ""};
  LastChanges changes = changes_of(*log);
  // What differs from the last commit, be it staged or not, and what is in none.
  const std::vector<std::string> open[] = {
      {"diff", "--no-ext-diff", "--no-textconv", "--ignore-submodules=all", "--name-only",
       "--relative", "HEAD", "--", folder},
      {"ls-files", "--others", "--", folder}};
  for (const std::vector<std::string>& question : open) {
    const auto answer = git->ask(question);
    if (!answer) return {{}, answer.error()};
    std::istringstream files(*answer);
    for (std::string line; std::getline(files, line);) changes[line] = {};
  }
  return {std::move(changes), ""};
}

}  // namespace mjcourse
