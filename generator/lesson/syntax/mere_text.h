// What looks like Markdown in the source and is mere text in the page: a reference that nobody
// defines, a link whose address has a blank, a formula in the brackets that LaTeX has for it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

struct MereText {
  std::size_t begin, end;  // in the source
  std::string id, message, cure;
};

// `source` is a paragraph, a heading or a table's row as it was written, and `shown` what a reader
// sees of it, which decides what is mere text.
std::vector<MereText> mere_text(std::string_view source, std::string_view shown);

// May there be any? A quick look that spares the other.
bool is_suspicious(std::string_view source);

}  // namespace mjcourse
