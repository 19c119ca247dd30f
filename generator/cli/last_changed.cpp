#include "cli/last_changed.h"

#include <sstream>
#include <utility>
#include <vector>

#include "base/subprocess.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostOutput = 64 << 20;  // bytes; the log of some hundred thousand changes

// What git prints, whose paths are below `root`; "" where it fails.
std::string git(const std::filesystem::path& root, std::vector<std::string> arguments) {
  Command command;
  command.arguments = {"git", "-c", "core.quotePath=false"};
  command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
  command.folder = root.string();
  command.seconds = 60;
  command.output_bytes = kMostOutput;
  Outcome outcome = run(command);
  const bool done = outcome.end == Outcome::End::exited && outcome.code == 0;
  return done ? std::move(outcome.out) : "";
}

}  // namespace

std::map<std::string, std::string> last_changed(const std::filesystem::path& root,
                                                const std::string& folder) {
  std::map<std::string, std::string> dates;
  // The newest commit comes first: its date, then the files that it changed.
  std::istringstream log(
      git(root, {"log", "--format=%x01%cs", "--name-only", "--relative", "--", folder}));
  std::string date;
  for (std::string line; std::getline(log, line);) {
    if (line.starts_with('\x01')) {
      date = line.substr(1);
    } else if (!line.empty()) {
      dates.try_emplace(line, date);
    }
  }
  for (const char* kind : {"--modified", "--others"}) {
    std::istringstream files(git(root, {"ls-files", kind, "--", folder}));
    for (std::string line; std::getline(files, line);) dates[line] = "not committed";
  }
  return dates;
}

}  // namespace mjcourse
