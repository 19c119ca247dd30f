// A page's place in the web: what its head says to search engines and to sites that show a link.
//
// Whole addresses come only from the course's `url`; without one, a page says what it is and not
// where.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "page/site_data.h"

namespace mjcourse {

// As place.hbs wants it, of the page `path`.
nlohmann::json web_place(const SiteData& site, const std::string& path, const PageHead& head);

}  // namespace mjcourse
