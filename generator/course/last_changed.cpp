#include "course/last_changed.h"

#include <optional>
#include <sstream>
#include <vector>

#include "course/git.h"

namespace mjcourse {

LastChanges last_changed(const std::filesystem::path& root, const std::string& folder) {
  LastChanges changes;
  const std::optional<Git> git = Git::find(root);
  // The commit at which a shallow clone ends looks as if it had made all files.
  if (!git || git->ask({"rev-parse", "--is-shallow-repository"}) != "false\n") return changes;
  // The newest commit comes first: its day and time, then the files that it changed.
  std::istringstream log(git->ask({"log", "--no-ext-diff", "--no-textconv", "--format=%x01%cs %cd",
                                   "--date=format-local:%Y-%m-%dT%H:%M:%SZ", "--name-only",
                                   "--relative", "--", folder}));
  LastChange change;
  for (std::string line; std::getline(log, line);) {
    if (line.starts_with('\x01')) {
      const std::size_t space = line.find(' ');
      change = {line.substr(1, space - 1), line.substr(space + 1)};
    } else if (!line.empty()) {
      changes.try_emplace(line, change);
    }
  }
  // What differs from the last commit, be it staged or not, and what is in none.
  const std::vector<std::string> open[] = {
      {"diff", "--no-ext-diff", "--no-textconv", "--ignore-submodules=all", "--name-only",
       "--relative", "HEAD", "--", folder},
      {"ls-files", "--others", "--", folder}};
  for (const std::vector<std::string>& question : open) {
    std::istringstream files(git->ask(question));
    for (std::string line; std::getline(files, line);) changes[line] = {};
  }
  return changes;
}

}  // namespace mjcourse
