#include "evaluate/program_files.h"

#include <filesystem>
#include <set>

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// Gathers files by what they are called in a course.
class Gathering {
 public:
  // `path` where it is a file in `folder`, which the course calls `name`. Was it in there?
  bool add(const fs::path& path, const fs::path& folder, const std::string& name) {
    const fs::path below = path.lexically_relative(fs::absolute(folder).lexically_normal());
    if (below.empty() || *below.begin() == "..") return false;
    std::error_code none;
    if (fs::is_regular_file(path, none)) found_.insert((name / below).generic_string());
    return true;
  }

  std::vector<std::string> take() const { return {found_.begin(), found_.end()}; }

 private:
  std::set<std::string> found_;
};

void add_sources(const std::vector<std::string>& sources, const Setting& setting,
                 Gathering& gathering) {
  for (const std::string& source : sources) {
    const fs::path path = fs::path(source).lexically_normal();
    bool included = false;
    for (const fs::path& folder : setting.include_folders()) {
      included = included || gathering.add(path, folder, "examples/include");
    }
    if (!included) gathering.add(path, setting.root() / "examples", "examples");
  }
}

// All that is right in `folder`, or all below it.
template <typename Iterator>
void add_models(const fs::path& folder, const fs::path& models, Gathering& gathering) {
  std::error_code none;
  for (const fs::directory_entry& entry : Iterator(folder, none)) {
    gathering.add(entry.path(), models, "models");
  }
}

}  // namespace

std::vector<std::string> program_files(const Compiled& compiled, const Outcome& outcome,
                                       const Setting& setting) {
  Gathering gathering;
  if (compiled.dependencies) add_sources(*compiled.dependencies, setting, gathering);
  for (const WarmObjects::Entry& entry : {compiled.header, compiled.handlers}) {
    if (entry) add_sources(entry->inputs, setting, gathering);
  }
  const fs::path handlers = handlers_source(setting.include_folders());
  if (!handlers.empty()) add_sources({fs::absolute(handlers).string()}, setting, gathering);
  const fs::path models = fs::absolute(setting.root() / "models").lexically_normal();
  if (!outcome.opened) add_models<fs::recursive_directory_iterator>(models, models, gathering);
  for (const std::string& opened : outcome.opened.value_or(std::vector<std::string>())) {
    if (!gathering.add(opened, models, "models")) continue;
    // Who lists a folder wants what is in it.
    if (fs::is_directory(opened)) add_models<fs::directory_iterator>(opened, models, gathering);
  }
  return gathering.take();
}

}  // namespace mjcourse
