// Markdown that is none, since it stands in a block of raw HTML.
//
// Such a block goes on until an empty line, and CommonMark leaves all of it as it is: a fence below
// `<details>` is shown as backticks, and nobody runs it.
// Tested by tests/generator/lesson/blocks/read_html_test.cpp.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace mjcourse {

struct HiddenMarkdown {
  std::size_t begin, end;
  const char* what;  // "a fence"
};

// All in `html`; of a list only its first item. What stands in `<code>` or `<pre>` is meant as it
// stands.
std::vector<HiddenMarkdown> hidden_markdown(std::string_view html);

}  // namespace mjcourse
