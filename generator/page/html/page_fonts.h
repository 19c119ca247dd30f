// What fonts a page is set in, found in its HTML.
//
// A browser finds a font once it lays out the first text that is set in it. Then it asks for the
// font, and when that has come, it lays out the whole page anew. A site that knows ahead what a
// page needs can ask at once, and the page is laid out once. Enter with page_fonts().
#pragma once

#include <string_view>
#include <vector>

namespace mjcourse {

// The fonts of the page `body`, under the names that the site's manifest has for them, each once:
// those of its text first. Only such as are on many pages; a browser finds the rest.
std::vector<std::string_view> page_fonts(std::string_view body);

}  // namespace mjcourse
