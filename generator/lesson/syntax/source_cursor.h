// SourceCursor: where in the author's text the walk over its tree is.
//
// cmark says of no inline where it stood. So the walk goes through the text beside the tree, and
// finds each formula, code and link again, at or after where the one before it stood.
#pragma once

#include <cstddef>
#include <string>

#include "lesson/syntax/located_text.h"

namespace mjcourse {

struct SourceCursor {
  const LocatedText& text;
  std::size_t at = 0;

  // `part` where it stands next, line by line, since the lines of a quote are apart. Moves behind
  // it.
  LocatedText find(const std::string& part);

  // Move behind the next code span of this text. What stands in code is no term and no value. Code
  // that cmark changed (a line break in it) is not found in its paragraph, and passed by none.
  void pass_code(const std::string& code);
};

}  // namespace mjcourse
