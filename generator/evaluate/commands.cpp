#include "evaluate/commands.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/stopwatch.h"
#include "base/subprocess.h"
#include "base/temporary_folder.h"
#include "evaluate/containment.h"
#include "evaluate/judge_run.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// Copies files and folders of a course to the same names in another folder.
class Copies {
 public:
  Copies(fs::path to, Workshop& workshop) : to_(std::move(to)), workshop_(workshop) {}

  // False where it cannot be read. A link to another folder may lead in a circle, and stands for an
  // empty one.
  bool add(const std::string& name) {
    const fs::path& root = workshop_.root();
    if (!fs::is_directory(root / name)) return add_file(name);
    add_folder(name);
    bool whole = true;
    for (const auto& entry : fs::recursive_directory_iterator(
             root / name, fs::directory_options::skip_permission_denied)) {
      const std::string inside = entry.path().lexically_relative(root).string();
      if (entry.is_directory()) {
        add_folder(inside);
      } else {
        whole = add_file(inside) && whole;
      }
    }
    return whole;
  }

  // Whoever the commands run as may change the copies.
  void open_for_all() const {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(to_)) {
      fs::permissions(entry, entry.is_directory() ? fs::perms::all : fs::perms(0666));
    }
  }

  std::vector<std::string> files() const { return {files_.begin(), files_.end()}; }

 private:
  bool add_file(const std::string& name) {
    const auto bytes = workshop_.files().read(name);
    if (bytes) write_file(to_ / name, *bytes);
    files_.insert(name);
    return bytes.has_value();
  }
  void add_folder(const std::string& name) {
    workshop_.trace().file(name);
    fs::create_directories(to_ / name);
  }

  fs::path to_;
  Workshop& workshop_;
  std::set<std::string> files_;
};

bool add_all(const Commands& commands, const Lesson& lesson, Copies& copies,
             Diagnostics& diagnostics) {
  bool whole = true;
  for (const LocatedText& file : commands.files) {
    if (copies.add(file.text)) continue;
    whole = false;
    diagnostics.push_back(error_at(place_of(*lesson.source, file.span()), "E-commands-file",
                                   "the course has no `" + file.text + "`",
                                   "name a file or a folder as seen from the course's folder"));
  }
  copies.open_for_all();
  return whole;
}

// `text` with a dot for `folder`, which is another each time.
std::string without_folder(std::string text, const std::string& folder) {
  for (std::size_t at = 0; (at = text.find(folder, at)) != text.npos;) {
    text.replace(at, folder.size(), ".");
  }
  return text;
}

}  // namespace

std::optional<ExampleResult> evaluate_commands(const Commands& commands, const Lesson& lesson,
                                               Workshop& workshop, Diagnostics& diagnostics) {
  const TemporaryFolder folder;
  const fs::path script = folder.path() / "commands.sh", place = folder.path() / "course";
  write_file(script, commands.code.text);
  fs::create_directory(place);
  Copies copies(place, workshop);
  if (!add_all(commands, lesson, copies, diagnostics)) return std::nullopt;
  // All that is installed may have a part in it.
  workshop.trace().file(kInstalledPackages);

  Command command;
  // A command that fails is the last, and stderr names each before what it says.
  command.arguments = {"sh", "-ex", "../" + script.filename().string()};
  command.folder = place;
  command.seconds = commands.seconds;
  command.sandbox = commands_sandbox(script, place);
  const Stopwatch stopwatch;
  Outcome outcome = run(command);
  const double seconds = stopwatch.seconds();
  if (auto wrong = judge_run(outcome, {"listing", commands.seconds})) {
    wrong->place = place_of(*lesson.source, commands.span);
    diagnostics.push_back(*std::move(wrong));
    return std::nullopt;
  }
  return ExampleResult{commands.code.text,
                       without_folder(std::move(outcome.out), place.string()),
                       {},
                       seconds,
                       copies.files()};
}

}  // namespace mjcourse
