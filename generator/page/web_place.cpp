#include "page/web_place.h"

#include "page/html/site_paths.h"
#include "page/lesson_history.h"

namespace mjcourse {

using nlohmann::json;

namespace {

// Inside of a script element, which ends at the first `</script`, whatever is around that.
std::string embedded(const json& data) {
  std::string text = data.dump();
  for (std::size_t at = 0; (at = text.find('<', at)) != text.npos;) text.replace(at, 1, "\\u003c");
  return text;
}

// The same in the words of schema.org; "" of a page that is neither a course nor a lesson.
std::string facts_of(const SiteData& site, const std::string& address, const PageHead& head) {
  const Course& course = site.course;
  json facts{{"@context", "https://schema.org"},
             {"url", address},
             {"name", head.title},
             {"description", head.description},
             {"inLanguage", course.language}};
  if (head.kind == "home") {
    facts["@type"] = "Course";
    return embedded(facts);
  }
  if (head.current == nullptr) return "";
  facts["@type"] = "LearningResource";
  facts["learningResourceType"] = "lesson";
  facts["isPartOf"] = {
      {"@type", "Course"}, {"name", course.title}, {"url", web_address(course, "index.html")}};
  if (const auto minutes = head.current->front.minutes) {
    facts["timeRequired"] = "PT" + std::to_string(*minutes) + "M";
  }
  if (const LastChange* change = last_change(site, *head.current)) {
    facts["dateModified"] = change->time;
  }
  return embedded(facts);
}

json picture_data(const Course& course, const SharedPicture& picture) {
  return {{"address", web_address(course, picture.path)},
          {"width", picture.width},
          {"height", picture.height},
          {"alt", picture.alt}};
}

}  // namespace

json web_place(const SiteData& site, const std::string& path, const PageHead& head) {
  const std::string address = head.anywhere ? "" : web_address(site.course, path);
  json place{{"title", head.title},
             {"description", head.description},
             {"kind", head.kind == "lesson" ? "article" : "website"},
             {"site", site.course.title},
             {"address", address},
             {"search", address.empty() ? "" : head.root + kOpenSearch},
             {"feed", site.feed ? head.root + kFeed : ""},
             {"picture", nullptr},
             {"facts", ""}};
  if (address.empty()) return place;
  if (head.picture) place["picture"] = picture_data(site.course, *head.picture);
  place["facts"] = facts_of(site, address, head);
  return place;
}

}  // namespace mjcourse
