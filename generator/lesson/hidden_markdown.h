// Markdown that is none, since it stands in a block of raw HTML.
//
// Such a block goes on until an empty line, and CommonMark leaves all of it as it is: a fence below
// `<details>` is shown as backticks, and nobody runs it.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace mjcourse {

struct HiddenMarkdown {
  std::size_t begin, end;
  const char* what;  // "a fence"
};

// The first in `html`. What stands in `<code>` or `<pre>` is meant as it stands.
std::optional<HiddenMarkdown> hidden_markdown(std::string_view html);

}  // namespace mjcourse
