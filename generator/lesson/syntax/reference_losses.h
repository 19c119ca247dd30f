// Definitions of references, `[name]: https://…`, that cmark drops: those that nothing names, and
// of two with one name the second, where it has another address.
// Tested by tests/courses/text.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/syntax/loss.h"
#include "lesson/syntax/syntax_pointer.h"

namespace mjcourse {

class ReferenceLosses {
 public:
  // Looks into `parser` when it finishes, and must live as long.
  explicit ReferenceLosses(cmark_parser* parser);
  ReferenceLosses(const ReferenceLosses&) = delete;
  ReferenceLosses& operator=(const ReferenceLosses&) = delete;

  // Once the parser has finished; `text` is what it read, the first line of which is `first_line`.
  void note(std::string_view text, int first_line, Losses& losses) const;

 private:
  // The addresses of each name, in their order, the names as cmark compares them.
  std::map<std::string, std::vector<std::string>> defined_;
  SyntaxPointer watch_;
};

}  // namespace mjcourse
