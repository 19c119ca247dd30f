// Two YAML files held against each other by what they say.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace mjcourse {

// Of two trees without aliases: their values, in their order, whatever their layout.
bool same_tree(const YAML::Node& a, const YAML::Node& b);

// Whether a part of the file stands for another: one more line there is two more things.
bool has_aliases(const std::string& yaml);

}  // namespace mjcourse
