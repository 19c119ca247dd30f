// The name of a lesson's file, "1.2-generalized-coordinates", in its parts.
#pragma once

#include <optional>
#include <string>

namespace mjcourse {

struct LessonName {
  std::string level;  // "1", or "A" in an appendix
  int place = 0;      // 2
  std::string slug;   // "generalized-coordinates"

  std::string number() const { return level + "." + std::to_string(place); }
  std::string text() const { return number() + "-" + slug; }
};

// Nothing where `name` is none.
std::optional<LessonName> read_lesson_name(const std::string& name);

// What a title is called in a file's name: "Rigid bodies, 2" is "rigid-bodies-2". Empty where it
// has letters that are not English, or none at all. A heading's id is made otherwise
// (lesson/syntax/heading_id.h): links from elsewhere lead to it, so it is what other tools make of
// it.
std::string slug_of(const std::string& title);

// "Rigid bodies 2" of "rigid-bodies-2".
std::string title_of(const std::string& slug);

}  // namespace mjcourse
