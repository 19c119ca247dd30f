// The theme: what a course says of how its site looks, where it wants another look than it is
// given.
//
//   theme/templates/NAME.hbs   stands in the place of the site's template of that name; others are
//                              partials of these
//   theme/style.css            is loaded behind the site's stylesheet, whose rules are all in
//                              layers: so each rule here wins. Colours, faces and sizes are custom
//                              properties (site/browser/styles/tokens.css).
// Tested by tests/courses/course.
#pragma once

#include <string>

#include "base/files.h"
#include "report/diagnostic.h"

namespace mjcourse {

// Below the course's folder.
inline constexpr const char* kThemeTemplates = "theme/templates";
inline constexpr const char* kThemeStyle = "theme/style.css";

// The file of the course's template `name`.
std::string theme_template(const std::string& name);

// What is wrong with the theme of a course, where it has one: names that stand for nothing. What
// its templates do is seen when pages are written.
Diagnostics check_theme(const Files& course, const Files& assets);

// Has the course a template of that name?
bool is_themed(const std::string& template_name, const Files& course);

}  // namespace mjcourse
