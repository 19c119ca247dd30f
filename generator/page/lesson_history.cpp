#include "page/lesson_history.h"

#include <array>

#include "course/web_address.h"
#include "page/site_data.h"

namespace mjcourse {

const LastChange* last_change(const SiteData& site, const Lesson& lesson) {
  const auto found = site.changes.find(lesson.source->path());
  return found == site.changes.end() || !found->second.committed() ? nullptr : &found->second;
}

std::string day_in_words(const std::string& day) {
  constexpr std::array<const char*, 12> kMonths{"January",   "February", "March",    "April",
                                                "May",       "June",     "July",     "August",
                                                "September", "October",  "November", "December"};
  const auto month = static_cast<std::size_t>(std::stoi(day.substr(5, 2)));
  return std::to_string(std::stoi(day.substr(8))) + " " + kMonths.at(month - 1) + " " +
         day.substr(0, 4);
}

nlohmann::json history_data(const SiteData& site, const Lesson& lesson) {
  const LastChange* change = last_change(site, lesson);
  const std::string& edit = site.course.edit;
  if (change == nullptr && edit.empty()) return nullptr;
  return {{"day", change != nullptr ? change->day : ""},
          {"words", change != nullptr ? day_in_words(change->day) : ""},
          {"edit", edit.empty() ? "" : edit_address(edit, lesson.source->path())}};
}

}  // namespace mjcourse
