// The language of a course, a tag of BCP 47: `de`, `en-GB`, `zh-Hans`.
#pragma once

#include <optional>
#include <string>

namespace mjcourse {

// In small letters; script and region may be "".
struct LanguageParts {
  std::string language, script, region;
};

LanguageParts parts_of_language(const std::string& tag);

// What to write instead of `tag`, which does not have a tag's form; nothing where it does.
std::optional<std::string> cure_of_language(const std::string& tag);

// Is it written from right to left?
bool is_right_to_left(const std::string& tag);

}  // namespace mjcourse
