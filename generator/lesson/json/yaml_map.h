// YamlMap: read a YAML mapping key by key, and complain about what was not asked for.
//
// The YAML twin of JsonObject, for front matter and course.yaml.
// Tested by tests/generator/lesson/front_matter_test.cpp.
#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lesson/syntax/located_text.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

class YamlMap {
 public:
  // `what` names the mapping in messages ("front matter"); `text` is the YAML that `node` was
  // parsed from. `id` is the id of every error here.
  YamlMap(const YAML::Node& node, std::string what, std::string id, const LocatedText& text,
          Reading& reading);

  LocatedText string(const std::string& key);
  LocatedText required_string(const std::string& key);
  // A whole number, not less than 0.
  std::optional<int> count(const std::string& key);
  bool boolean(const std::string& key, bool otherwise);
  // A list of plain values.
  std::vector<LocatedText> strings(const std::string& key);
  // A mapping of names to plain values.
  std::map<std::string, std::string> texts(const std::string& key);
  // A list of what is nested; one without items is an error.
  std::vector<YAML::Node> required_items(const std::string& key);

  void finish();

 private:
  YAML::Node find(const std::string& key);
  LocatedText text_of(const YAML::Node& value, const std::string& key);
  LocatedText scalar(const YAML::Node& node) const;
  void error(const YAML::Node& node, const std::string& message, const std::string& cure = "");

  YAML::Node map_;
  bool is_map_ = true;
  std::string what_;
  std::string id_;
  const LocatedText& text_;
  Reading& reading_;
  std::vector<std::string> asked_;
};

// Parse `text`; on a syntax error, report `id` at its place and return nothing.
std::optional<YAML::Node> parse_yaml(const LocatedText& text, const std::string& what,
                                     const std::string& id, Reading& reading);

}  // namespace mjcourse
