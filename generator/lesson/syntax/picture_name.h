// How Markdown names a picture: the target `my%20arm.png`, or `<my arm.png>`, is the file
// "my arm.png".
#pragma once

#include <string>
#include <vector>

#include "lesson/syntax/located_text.h"

namespace mjcourse {

// The file that the target names, with its escapes put right.
LocatedText file_of_target(const LocatedText& target);

// What names `file` between the parentheses of a picture.
std::string target_of_file(const std::string& file);

// The names of pictures in parentheses that Markdown takes for text, since there is a blank in
// them:
// `](my arm.png)`. `text` is searched from `at` to its next empty line.
std::vector<LocatedText> names_with_blanks(const LocatedText& text, std::size_t at);

}  // namespace mjcourse
