// A diagnostic's id is explained by what it means, without looking at the course.
//
// Steps for the rest: find the lessons that are meant; look up what would be kept; tell of each
// task whether it is, and what has changed if not. Where a lesson or a line was named, tell all
// that it depends on too.
// Tested by tests/store/dependencies.mjs.
#include "evaluate/explain.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <string>

#include "base/counted.h"
#include "base/files.h"
#include "base/nearest.h"
#include "base/utf8.h"
#include "cli/commands.h"
#include "cli/explanation_file.h"
#include "cli/new_files.h"
#include "cli/run.h"
#include "cli/verify.h"
#include "cli/where.h"
#include "process/our_command.h"
#include "report/meaning.h"

namespace mjcourse {
namespace {

bool is_hash(std::string_view text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == text.npos;
}

// A hash by its first digits.
std::string short_value(const std::string& value) {
  return is_hash(value) ? value.substr(0, 8) : readable(value);
}

// Without the hash that a name may end with.
std::string short_name(const std::string& name) {
  const std::size_t space = name.rfind(' ');
  const bool has_hash = space != name.npos && is_hash(name.substr(space + 1));
  return readable(has_hash ? name.substr(0, space) : name);
}

void print_changes(const Explanation& task) {
  if (task.before.empty()) {
    std::cout << "  was never evaluated here\n";
    return;
  }
  std::map<std::string, std::string> before;
  for (const Dependency& one : task.before) before[one.name] = one.value;
  bool changed = false;
  for (const Dependency& one : task.now) {
    const auto known = before.find(one.name);
    const std::string was = known == before.end() ? "not looked at" : short_value(known->second);
    if (known != before.end() && known->second == one.value) continue;
    std::cout << "  " << short_name(one.name) << " changed: " << was << " → "
              << short_value(one.value) << '\n';
    changed = true;
  }
  if (!changed) std::cout << "  nothing has changed, but the result is no longer kept\n";
}

void print_dependencies(const Dependencies& all) {
  std::size_t width = 0, system = 0;
  for (const Dependency& one : all) {
    if (one.name.starts_with('/')) {
      ++system;
    } else {
      width = std::max(width, short_name(one.name).size());
    }
  }
  std::cout << "  depends on\n";
  for (const Dependency& one : all) {
    if (one.name.starts_with('/')) continue;
    const std::string name = short_name(one.name);
    std::cout << "    " << name << std::string(width + 2 - name.size(), ' ')
              << short_value(one.value) << '\n';
  }
  if (system > 0) std::cout << "    and " << counted(system, "file") << " of the system\n";
}

int explain_ids(const std::vector<std::string>& ids) {
  const TerminalStyle style = style_for(STDOUT_FILENO);
  std::string text;
  for (const std::string& id : ids) {
    const Meaning* meaning = meaning_of(id);
    if (meaning == nullptr) {
      std::vector<std::string> known;
      for (const Meaning& one : meanings()) known.emplace_back(one.id);
      const std::string near = nearest(id, known);
      std::cerr << "mjcourse: there is no message " << id
                << (near.empty() ? "; lesson A.9 of the author guide has them all"
                                 : "; did you mean `" + near + "`?")
                << '\n';
      return kWrongUsage;
    }
    text += (text.empty() ? "" : "\n") + format_for_terminal(*meaning, style);
  }
  std::cout << text;
  return kClean;
}

int hold_against(const std::filesystem::path& path, const ExplanationFile& here) {
  const auto text = read_file(path);
  const std::string cure = "write it on the other machine: " + our_command("explain --json > FILE");
  if (!text) return tell(Refusal{kWrongUsage, path.string() + " cannot be read", cure});
  const auto there = read_explanation_file(*text);
  if (!there) return tell(Refusal{kWrongUsage, path.string() + ": " + there.error(), cure});
  std::cout << differences(here, *there);
  return kClean;
}

// Where the result of a task is.
std::string state_of(const Explanation& task, const OpenedStore& store) {
  if (!task.kept) return "to be done";
  return store.came_from_server(task.result) ? "kept in the shared store as " + task.result
                                             : "kept";
}

}  // namespace

int explain(const ExplainOptions& options) {
  const auto ids = static_cast<std::size_t>(
      std::count_if(options.where.begin(), options.where.end(), is_like_id));
  if (ids > 0 && ids < options.where.size()) {
    std::cerr
        << "mjcourse: explain takes the names of messages or places in the course, not both\n";
    return kWrongUsage;
  }
  if (ids > 0) return explain_ids(options.where);
  Verified verified = read_course_of(options);
  if (!verified.course) {
    print_diagnostics(verified.evaluation.diagnostics);
    return kCourseErrors;
  }
  std::vector<Where> wanted;
  for (const std::string& text : options.where) {
    const auto place = find_place(*verified.course, options.course, text);
    if (!place) {
      std::cerr << "mjcourse: " << readable(place.error()) << '\n';
      return kWrongUsage;
    }
    wanted.push_back(*place);
  }
  if (verified.store.get() == nullptr) return kClean;  // it was said that there is no store
  const DiskFiles assets(assets_folder());
  const std::vector<Explanation> tasks =
      explain_course(*verified.course, evaluation_settings(options, assets, verified.store.get()));
  if (options.json) std::cout << text_of(explanation_file(tasks));
  if (!options.against.empty()) return hold_against(options.against, explanation_file(tasks));
  if (options.json) return kClean;
  std::size_t kept = 0, told = 0;
  for (const Explanation& task : tasks) {
    const bool meant =
        wanted.empty() || std::any_of(wanted.begin(), wanted.end(),
                                      [&](const Where& where) { return where.has(task.place); });
    if (!meant) continue;
    ++told;
    kept += task.kept ? 1 : 0;
    std::cout << readable(task.place.file) << ":" << task.place.line << ": " << task.what << ": "
              << state_of(task, verified.store) << '\n';
    if (!task.kept) print_changes(task);
    if (!wanted.empty()) print_dependencies(task.now);
  }
  std::cout << counted(told, "task") << ", " << kept << " kept\n";
  return kClean;
}

}  // namespace mjcourse
