// What the style attribute of raw HTML may say.
//
// The site moves styles into a sheet of its own (page/html/inline_styles.h). So one that closes a
// brace would become a rule for all of the page, and one that is placed on the screen could cover
// it.
// Tested by tests/generator/lesson/blocks/read_html_test.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

struct StyleFault {
  std::size_t begin, end;
  std::string message, cure;
};

// What is wrong with the first declaration that may not stand there.
std::optional<StyleFault> style_fault(std::string_view style);

}  // namespace mjcourse
