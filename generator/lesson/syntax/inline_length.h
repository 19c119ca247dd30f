// How far what begins in a line reaches, by the rules of Markdown: a formula, a piece of code.
//
// For code that looks at the source beside cmark's tree.
// Tested by tests/generator/lesson/syntax/math_syntax_test.cpp.
#pragma once

#include <cstddef>
#include <set>
#include <string_view>

namespace mjcourse {

// Of the formula that `text`, which starts with a dollar, opens, with its dollars; 0 when that
// dollar is text.
std::size_t math_length(std::string_view text);

// Of the code spans of one text, asked for from its front to its end.
class CodeLengths {
 public:
  // Of the code span that the rest of the text, `rest`, opens with a backtick, with all of these; 0
  // when no run of as many closes it.
  std::size_t at(std::string_view rest);

 private:
  std::set<std::size_t> unclosed_;  // runs of so many that nothing closes from here on
};

// Of the backticks that `text` starts with.
std::size_t backticks(std::string_view text);

}  // namespace mjcourse
