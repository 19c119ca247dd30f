#include "course/course_listing.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/utf8.h"
#include "course/lesson_name.h"
#include "course/yaml_insertion.h"
#include "course/yaml_tree.h"

namespace mjcourse {
namespace {

std::optional<YAML::Node> parse(const std::string& yaml) {
  try {
    return YAML::Load(yaml);
  } catch (const YAML::Exception&) {
    return std::nullopt;
  }
}

// A text as YAML reads it: plain where nothing in it means anything, else in quotes as JSON's.
std::string yaml_text(const std::string& text) {
  const bool plain = std::all_of(text.begin(), text.end(), [](char c) {
    return is_letter_or_digit(c) || c == ' ' || c == '-';
  });
  bool truth = false;  // "yes", "off"
  const bool word = plain && is_letter(text[0]) && text.back() != ' ' &&
                    YAML::Load(text).IsScalar() &&
                    !YAML::convert<bool>::decode(YAML::Node(text), truth);
  return word ? text : nlohmann::json(text).dump();
}

// `after` is `before` but for the item `index` of the list that `list_of` finds, which is `item`.
template <typename ListOf>
std::optional<std::string> verified(const YAML::Node& before, std::optional<std::string> after,
                                    ListOf list_of, std::size_t index, const YAML::Node& item) {
  const std::optional<YAML::Node> tree = after ? parse(*after) : std::nullopt;
  if (!tree || has_aliases(*after)) return std::nullopt;
  YAML::Node list = list_of(*tree);
  if (!list || !list.IsSequence() || index >= list.size() || !same_tree(list[index], item))
    return std::nullopt;
  list.remove(index);
  return same_tree(*tree, before) ? after : std::nullopt;
}

int number_of(const std::string& digits) {
  return digits.empty() ? -1 : std::stoi(digits.substr(0, 9));
}

// Where among `levels` a new one comes.
std::size_t place_of_level(const std::vector<ListedLevel>& levels, const std::string& folder) {
  const int number = number_of(level_number(folder));
  if (number < 0) return levels.size();
  std::size_t place = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const int other = number_of(levels[i].number);
    if (other >= 0 && other < number) place = i + 1;
  }
  return place;
}

std::size_t place_of_lesson(const std::vector<std::string>& lessons, const std::string& name) {
  const auto own = read_lesson_name(name);
  const auto later = std::find_if(lessons.begin(), lessons.end(), [&](const std::string& one) {
    const auto other = read_lesson_name(one);
    return own && other && other->level == own->level && other->place > own->place;
  });
  return static_cast<std::size_t>(later - lessons.begin());
}

}  // namespace

std::string level_number(const std::string& folder) {
  return folder.substr(0, std::min(folder.find_first_not_of("0123456789"), folder.size()));
}

std::optional<std::vector<ListedLevel>> read_listing(const std::string& yaml) {
  const std::optional<YAML::Node> tree = parse(yaml);
  if (!tree || !tree->IsMap()) return std::nullopt;
  const YAML::Node nodes = (*tree)["levels"];
  if (!nodes || !nodes.IsSequence()) return std::nullopt;
  std::vector<ListedLevel> levels;
  for (const YAML::Node& node : nodes) {
    if (!node.IsMap() || !node["folder"] || !node["folder"].IsScalar()) return std::nullopt;
    const std::string folder = node["folder"].Scalar();
    levels.push_back({folder, level_number(folder), {}});
    const YAML::Node lessons = node["lessons"];
    if (lessons && !lessons.IsSequence()) return std::nullopt;
    if (!lessons) continue;
    for (const YAML::Node& lesson : lessons) {
      if (!lesson.IsScalar()) return std::nullopt;
      levels.back().lessons.push_back(lesson.Scalar());
    }
  }
  return levels;
}

std::optional<std::string> with_level(const std::string& yaml, const std::string& folder,
                                      const std::string& title) {
  const auto levels = read_listing(yaml);
  if (!levels) return std::nullopt;
  const YAML::Node before = YAML::Load(yaml);
  const std::size_t index = place_of_level(*levels, folder);
  const std::string text = yaml_text(title);
  const YamlItem item{{"folder: " + folder, "title: " + text, "lessons: []"},
                      "{folder: " + folder + ", title: " + text + ", lessons: []}"};
  return verified(
      before, insert_item(yaml, before["levels"], index, item),
      [](const YAML::Node& tree) { return tree["levels"]; }, index, YAML::Load(item.flow));
}

std::optional<std::string> with_lesson(const std::string& yaml, const std::string& folder,
                                       const std::string& name) {
  const auto levels = read_listing(yaml);
  if (!levels) return std::nullopt;
  const auto level = std::find_if(levels->begin(), levels->end(),
                                  [&](const ListedLevel& one) { return one.folder == folder; });
  if (level == levels->end()) return std::nullopt;
  const auto at = static_cast<std::size_t>(level - levels->begin());
  YAML::Node before = YAML::Load(yaml);
  const YAML::Node node = before["levels"][at];
  const std::size_t index = place_of_lesson(level->lessons, name);
  const YAML::Node lessons = node["lessons"];
  std::optional<std::string> after;
  if (lessons && lessons.IsSequence()) {
    after = insert_item(yaml, lessons, index, {{name}, name});
  } else if (!lessons) {
    after = append_line(yaml, node, "lessons: [" + name + "]");
    before["levels"][at]["lessons"] = YAML::Node(YAML::NodeType::Sequence);
  }
  return verified(
      before, std::move(after),
      [&](const YAML::Node& tree) { return tree["levels"][at]["lessons"]; }, index,
      YAML::Node(name));
}

}  // namespace mjcourse
