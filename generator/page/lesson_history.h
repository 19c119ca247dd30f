// What the foot of a lesson says of its past and its future: when it was changed, where to edit it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "page/site_data.h"

namespace mjcourse {

// When the lesson's file was changed last; null where git does not know it.
const LastChange* last_change(const SiteData& site, const Lesson& lesson);

// "3 March 2026" of "2026-03-03".
std::string day_in_words(const std::string& day);

// As history.hbs wants it; null where there is nothing to say.
nlohmann::json history_data(const SiteData& site, const Lesson& lesson);

}  // namespace mjcourse
