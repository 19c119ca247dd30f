#include "course/last_changed.h"

#include <sstream>
#include <utility>
#include <vector>

#include "base/subprocess.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostOutput = 64 << 20;  // bytes; the log of some hundred thousand changes
constexpr double kSeconds = 60;

// What git prints, whose paths are below `root`; "" where it fails. What the user set up for git
// must not show in it.
std::string git(const std::filesystem::path& root, std::vector<std::string> arguments) {
  Command command;
  command.arguments = {"git", "-c", "core.quotePath=false", "-c", "log.showSignature=false"};
  command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
  command.folder = root.string();
  command.environment = {"TZ=UTC", "GIT_OPTIONAL_LOCKS=0"};
  command.seconds = kSeconds;
  command.output_bytes = kMostOutput;
  Outcome outcome = run(command);
  const bool done = outcome.end == Outcome::End::exited && outcome.code == 0;
  return done ? std::move(outcome.out) : "";
}

}  // namespace

LastChanges last_changed(const std::filesystem::path& root, const std::string& folder) {
  LastChanges changes;
  // The commit at which a shallow clone ends looks as if it had made all files.
  if (git(root, {"rev-parse", "--is-shallow-repository"}) != "false\n") return changes;
  // The newest commit comes first: its day and time, then the files that it changed.
  std::istringstream log(
      git(root, {"log", "--format=%x01%cs %cd", "--date=format-local:%Y-%m-%dT%H:%M:%SZ",
                 "--name-only", "--relative", "--", folder}));
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
      {"diff", "--name-only", "--relative", "HEAD", "--", folder},
      {"ls-files", "--others", "--", folder}};
  for (const std::vector<std::string>& question : open) {
    std::istringstream files(git(root, question));
    for (std::string line; std::getline(files, line);) changes[line] = {};
  }
  return changes;
}

}  // namespace mjcourse
