// A course's own words within the Markdown that an editor shows: they stay words. An editor loads
// the pictures and follows the links of what it shows, and a course may be a stranger's.
#pragma once

#include <string>
#include <string_view>

namespace mjcourse {

// `words` as prose, on one line.
std::string escaped_for_markdown(std::string_view words);

// `words` as code, on one line; "" for none.
std::string code_for_markdown(std::string_view words);

}  // namespace mjcourse
