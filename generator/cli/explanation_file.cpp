#include "cli/explanation_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/counted.h"
#include "base/utf8.h"
#include "process/loaded_libraries.h"

namespace mjcourse {
namespace {

using nlohmann::json;
using Pairs = std::vector<std::pair<std::string, std::string>>;

constexpr const char* kForm = "mjcourse explain 1";

struct Difference {
  std::string name, here, there;
  auto operator<=>(const Difference&) const = default;
};

std::optional<Difference> first_difference(const Dependencies& here, const Dependencies& there) {
  const auto value_in = [](const Dependencies& all, const std::string& name) -> std::string {
    const auto found = std::ranges::find(all, name, &Dependency::name);
    return found == all.end() ? "not looked at" : found->value;
  };
  for (const Dependency& one : here) {
    std::string other = value_in(there, one.name);
    if (other != one.value) return Difference{one.name, one.value, std::move(other)};
  }
  for (const Dependency& one : there) {
    std::string own = value_in(here, one.name);
    if (own != one.value) return Difference{one.name, std::move(own), one.value};
  }
  return std::nullopt;
}

std::string libraries_that_differ(const ExplanationFile& here, const ExplanationFile& there) {
  std::map<std::string, std::pair<std::string, std::string>> all;
  for (const auto& [name, id] : here.libraries) all[name].first = id;
  for (const auto& [name, id] : there.libraries) all[name].second = id;
  std::string text;
  for (const auto& [name, ids] : all) {
    if (ids.first == ids.second) continue;
    const auto shown = [](const std::string& id) { return id.empty() ? "none" : id.substr(0, 8); };
    text += readable("    " + name + ": build " + shown(ids.first) + " here, " + shown(ids.second) +
                     " there") +
            "\n";
  }
  return text;
}

}  // namespace

ExplanationFile explanation_file(const std::vector<Explanation>& tasks) {
  ExplanationFile file{library_builds(), {}};
  for (const Explanation& task : tasks) {
    file.tasks[task.place.file + ":" + std::to_string(task.place.line) + ": " + task.what] =
        task.now;
  }
  return file;
}

std::string text_of(const ExplanationFile& file) {
  json tasks = json::object();
  for (const auto& [name, dependencies] : file.tasks) {
    Pairs pairs;
    for (const Dependency& one : dependencies) pairs.emplace_back(one.name, one.value);
    tasks[name] = pairs;
  }
  const json all{{"form", kForm}, {"libraries", file.libraries}, {"tasks", std::move(tasks)}};
  return all.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

tl::expected<ExplanationFile, std::string> read_explanation_file(const std::string& text) {
  ExplanationFile file;
  try {
    const json all = json::parse(text);
    if (all.at("form") != kForm)
      return tl::unexpected<std::string>("another version of mjcourse wrote it");
    all.at("libraries").get_to(file.libraries);
    for (const auto& [name, pairs] : all.at("tasks").get<std::map<std::string, Pairs>>()) {
      for (const auto& [dependency, value] : pairs) file.tasks[name].push_back({dependency, value});
    }
  } catch (const json::exception&) {
    return tl::unexpected<std::string>("it is not what `mjcourse explain --json` writes");
  }
  return file;
}

std::string differences(const ExplanationFile& here, const ExplanationFile& there) {
  std::map<Difference, std::vector<std::string>> found;  // and the tasks that have it
  std::size_t same = 0, alone = 0;
  for (const auto& [name, dependencies] : here.tasks) {
    const auto other = there.tasks.find(name);
    if (other == there.tasks.end()) {
      ++alone;
    } else if (auto difference = first_difference(dependencies, other->second)) {
      found[*std::move(difference)].push_back(name);
    } else {
      ++same;
    }
  }
  std::string text;
  for (const auto& [difference, tasks] : found) {
    text += readable(difference.name + ": " + difference.here + " here, " + difference.there +
                     " there") +
            "\n  " + readable(tasks.front()) +
            (tasks.size() > 1 ? ", and " + counted(tasks.size() - 1, "other task") : "") + "\n";
    if (difference.name == "libraries") text += libraries_that_differ(here, there);
  }
  return text + counted(same, "task") + " with the same dependencies" +
         (alone > 0 ? ", " + std::to_string(alone) + " that the other does not have" : "") + "\n";
}

}  // namespace mjcourse
