// A page's place in the web: what its head says to search engines and to those who show a link.
//
// Whole addresses come only from the course's `url`; without one, a page says what it is and not
// where.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "page/page_press.h"

namespace mjcourse {

// Where the page or file `path` of the site is published; "" where the course has no address.
std::string web_address(const Course& course, const std::string& path);

// As place.hbs wants it, of the page `path`.
nlohmann::json web_place(const SiteData& site, const std::string& path, const PageHead& head);

}  // namespace mjcourse
