#include "actions/program_files.h"

#include <filesystem>
#include <set>
#include <utility>

#include "base/files.h"
#include "process/sandbox.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// Gathers files by what they are called in a course.
class Gathering {
 public:
  // What is in `folder` the course calls `name`/…; of folders in each other the inner one comes
  // first. A compiler names a thousand files for each program, so these are made ready once.
  void know(const fs::path& folder, const std::string& name) {
    folders_.emplace_back(fs::absolute(folder).lexically_normal().string(), name);
  }

  // `path`, which is absolute, where it is a file in one of the folders. Is it in there?
  bool add(const fs::path& path) {
    const std::string normal = path.lexically_normal().string();
    for (const auto& [folder, name] : folders_) {
      if (!is_within(normal, folder)) continue;
      std::error_code none;
      if (fs::is_regular_file(path, none)) found_.insert(name + normal.substr(folder.size()));
      return true;
    }
    return false;
  }

  void add_all(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) add(path);
  }

  // All that is right in `folder`, or all below it.
  template <typename Iterator>
  void add_entries(const fs::path& folder) {
    std::error_code none;
    for (const fs::directory_entry& entry : Iterator(folder, none)) add(entry.path());
  }

  void give_to(std::vector<std::string>& files) const {
    files.insert(files.end(), found_.begin(), found_.end());
  }

 private:
  std::vector<std::pair<std::string, std::string>> folders_;
  std::set<std::string> found_;
};

Gathering sources_of(const Compiled& compiled, const IncludeFolders& include,
                     const fs::path& root) {
  Gathering sources;
  for (const fs::path& folder : include) sources.know(folder, "examples/include");
  sources.know(root / "examples", "examples");
  if (compiled.dependencies) sources.add_all(*compiled.dependencies);
  for (const WarmObjects::Entry& entry : {compiled.header, compiled.handlers}) {
    if (entry) sources.add_all(entry->inputs);
  }
  const fs::path handlers = handlers_source(include);
  if (!handlers.empty()) sources.add(fs::absolute(handlers));
  return sources;
}

Gathering models_of(const Outcome& outcome, const fs::path& root) {
  Gathering models;
  const fs::path folder = fs::absolute(root / "models").lexically_normal();
  models.know(folder, "models");
  if (!DiskFiles(root).is_folder("models")) return models;
  if (!outcome.opened) models.add_entries<fs::recursive_directory_iterator>(folder);
  for (const std::string& opened : outcome.opened.value_or(std::vector<std::string>())) {
    // A program that lists a folder wants what is in it.
    if (models.add(opened) && fs::is_directory(opened)) {
      models.add_entries<fs::directory_iterator>(opened);
    }
  }
  return models;
}

}  // namespace

std::vector<std::string> program_files(const Compiled& compiled, const Outcome& outcome,
                                       const IncludeFolders& include, const fs::path& root) {
  std::vector<std::string> files;
  sources_of(compiled, include, root).give_to(files);
  models_of(outcome, root).give_to(files);
  return files;
}

}  // namespace mjcourse
