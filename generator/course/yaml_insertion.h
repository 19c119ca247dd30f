// One more item in a list of a YAML file, put into the file's text, so that its comments and its
// layout stay.
//
// Enter at insert_item. YAML can be written in more ways than are understood here; a text that is
// not, or not surely, is left alone. The caller parses what came out and looks whether it is what
// was meant (course_listing.h).
//
// npm's `yaml` keeps comments too, but writes the whole file anew: the blanks before comments, the
// indentation and the line ends become its own.
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <vector>

namespace mjcourse {

// An item in both of YAML's styles.
struct YamlItem {
  std::vector<std::string> lines;  // {"folder: 1-a", "title: A"}, to stand behind a `- `
  std::string flow;                // "{folder: 1-a, title: A}"
};

// `text` with `item` as the item `index` of `sequence`, which was parsed from it; nothing where the
// list is laid out in no way that we know.
std::optional<std::string> insert_item(const std::string& text, const YAML::Node& sequence,
                                       std::size_t index, const YamlItem& item);

// `text` with the line `line` as the last of the block mapping `item`, which is an item of a block
// sequence.
std::optional<std::string> append_line(const std::string& text, const YAML::Node& item,
                                       const std::string& line);

}  // namespace mjcourse
