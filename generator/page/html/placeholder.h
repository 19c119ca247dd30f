// Stands in a template's data for a piece that never takes the way through the script engine: large
// ones would only be copied there. It is put in its place once the template is rendered.
#pragma once

#include <string>
#include <string_view>

namespace mjcourse {

// Between two control characters, which no page has.
std::string placeholder(std::string_view name);

// Puts `text` where `html` has the placeholder of that name. False, and nothing is done, where it
// has none or more than one: a course's own template may have lost it.
bool fill_placeholder(std::string& html, std::string_view name, std::string_view text);

}  // namespace mjcourse
