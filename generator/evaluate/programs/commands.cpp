#include "evaluate/programs/commands.h"

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/out_folder.h"
#include "base/stopwatch.h"
#include "base/temporary_folder.h"
#include "evaluate/programs/judge_run.h"
#include "process/subprocess.h"
#include "report/refused_file.h"
#include "toolchain/containment.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// Copies files and folders of a course to the same names in another folder.
class Copies {
 public:
  Copies(const fs::path& to, WorkerContext& worker_context)
      : to_(to), worker_context_(worker_context), files_(worker_context.root()) {}

  struct Refused {
    std::string path;
    FileRefusal refusal;
  };
  // False where it cannot be read. A link to another folder may lead in a circle, and stands for an
  // empty one.
  bool add(const std::string& name) {
    if (!files_.is_folder(name)) return add_file(name);
    add_folder(name);
    bool whole = true;
    for (const DiskFiles::Entry& entry : files_.below(name)) {
      if (entry.is_folder || files_.is_folder(entry.path)) {
        add_folder(entry.path);
      } else {
        whole = add_file(entry.path) && whole;
      }
    }
    return whole;
  }

  // The first that was refused.
  const std::optional<Refused>& refused() const { return refused_; }

  // The user that the commands run as may change the copies.
  void open_for_all() const {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(to_.path())) {
      fs::permissions(entry, entry.is_directory() ? fs::perms::all : fs::perms(0666));
    }
  }

  std::vector<std::string> files() const { return {names_.begin(), names_.end()}; }

 private:
  bool add_file(const std::string& name) {
    const auto bytes = worker_context_.files().read(name);
    if (bytes) to_.write(name, *bytes);
    names_.insert(name);
    auto refusal = bytes ? std::nullopt : files_.refusal(name);
    if (refusal && !refused_) refused_ = {name, *std::move(refusal)};
    return bytes.has_value();
  }
  void add_folder(const std::string& name) {
    worker_context_.trace().file(name);
    to_.inner(name);
  }

  OutFolder to_;
  WorkerContext& worker_context_;
  DiskFiles files_;
  std::set<std::string> names_;
  std::optional<Refused> refused_;
};

bool add_all(const Commands& commands, const Lesson& lesson, Copies& copies,
             Diagnostics& diagnostics) {
  bool whole = true;
  for (const LocatedText& file : commands.files) {
    if (copies.add(file.text)) continue;
    whole = false;
    if (const auto& refused = copies.refused()) {
      diagnostics.push_back(
          refused_file(place_of(*lesson.source, file.span()), refused->path, refused->refusal));
      continue;
    }
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
                                               WorkerContext& worker_context,
                                               Diagnostics& diagnostics) {
  if (auto why = worker_context.run_context().why_nothing_runs()) {
    why->place = place_of(*lesson.source, commands.span);
    diagnostics.push_back(*std::move(why));
    return std::nullopt;
  }
  const TemporaryFolder folder;
  const fs::path script = folder.path() / "commands.sh", place = folder.path() / "course";
  write_file(script, commands.code.text);
  fs::create_directory(place);
  Copies copies(place, worker_context);
  if (!add_all(commands, lesson, copies, diagnostics)) return std::nullopt;
  // All that is installed may have a part in it.
  worker_context.trace().file(kInstalledPackages);

  Command command;
  // A command that fails is the last, and stderr names each before what it says.
  command.arguments = {"sh", "-ex", "../" + script.filename().string()};
  command.folder = place;
  command.seconds = commands.seconds;
  command.sandbox = commands_sandbox(script, place);
  const Stopwatch stopwatch;
  Outcome outcome = run(command);
  const double seconds = stopwatch.seconds();
  if (auto wrong = judge_run(outcome, {"listing", commands.seconds, 0, *command.sandbox})) {
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
