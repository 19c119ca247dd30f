#include "cli/ci_files.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/nearest.h"
#include "cli/new_part.h"
#include "cli/skeleton.h"
#include "process/our_command.h"

namespace mjcourse {
namespace {

// In skeleton/ci/NAME as in the course.
const std::map<std::string, std::vector<std::string>> kFiles{
    {"github", {".github/workflows/course.yml", ".github/actions/mjcourse/action.yml"}},
    {"gitlab", {".gitlab-ci.yml"}},
    {"slurm", {"course.slurm"}},
    {"kubernetes", {"course-job.yaml"}}};

}  // namespace

const std::vector<std::string>& ci_names() {
  static const std::vector<std::string> names{"github", "gitlab", "slurm", "kubernetes"};
  return names;
}

std::vector<NewFile> ci_files(const Files& assets, const std::string& name) {
  std::vector<NewFile> files;
  for (const std::string& path : kFiles.at(name)) {
    files.push_back({path, filled_skeleton(assets, "ci/" + name + "/" + path, {})});
  }
  return files;
}

NewPartOrRefusal new_ci(const Files& assets, const std::vector<std::string>& words) {
  const std::string form = our_command("new ci gitlab");
  if (words.empty()) return wrong_words("new ci needs a name", "as in " + form);
  if (words.size() > 1) {
    return wrong_words("new ci takes a name, not `" + words[1] + "`", "as in " + form);
  }
  const std::vector<std::string>& names = ci_names();
  if (std::ranges::find(names, words[0]) == names.end()) {
    return wrong_words("there is no file for `" + words[0] + "`", suggest(words[0], names));
  }
  std::vector<NewFile> files = ci_files(assets, words[0]);
  std::string next = "the first lines of " + files.front().path + " say what has to be set up";
  return NewPart{std::move(files), "", std::move(next)};
}

}  // namespace mjcourse
