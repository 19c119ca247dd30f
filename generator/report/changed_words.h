// Which words of a line are new: what a diff marks.
#pragma once

#include <string>
#include <string_view>

namespace mjcourse {

struct ChangedWords {
  double alike = 0;  // how much of the two lines is the same, from 0 to 1
  std::string gone,
      come;  // "  ^~~ ": a line to stand beneath, of what the other lacks; may be empty
};

ChangedWords changed_words(std::string_view before, std::string_view after);

}  // namespace mjcourse
