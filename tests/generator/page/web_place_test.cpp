#include "page/web_place.h"

#include <gtest/gtest.h>

#include "page/site_data.h"
#include "page/site_of.h"

namespace mjcourse {
namespace {

using nlohmann::json;

TEST(WebPlace, OfACourseWithoutAnAddressHasNone) {
  const SiteOf site;
  const PageHead head{"lesson",
                      "1.1 One",
                      "What",
                      "../",
                      &site.course.lessons[0],
                      SharedPicture{"1-a/1.1-x/lab-1.png", 4, 2, "A lab"}};
  EXPECT_EQ(web_place(site.data, "1-a/1.1-x.html", head), json::parse(R"({
      "title": "1.1 One", "description": "What", "kind": "article", "site": "C",
      "address": "", "feed": "", "search": "", "picture": null, "facts": ""})"));
}

TEST(WebPlace, OfALessonIsItsPagesAddress) {
  SiteOf site;
  site.course.url = "https://example.org/c/";
  site.data.feed = true;
  site.data.changes["content/1-a/1.1-x.md"] = {"2026-03-03", "2026-03-04T04:30:00Z"};
  const PageHead head{
      "lesson", "1.1 </script>",         "What",
      "../",    &site.course.lessons[0], SharedPicture{"1-a/1.1-x/lab-1.png", 4, 2, "A lab"}};
  json place = web_place(site.data, "1-a/1.1-x.html", head);
  const std::string facts = place["facts"];
  place.erase("facts");
  EXPECT_EQ(place, json::parse(R"({
      "title": "1.1 </script>", "description": "What", "kind": "article", "site": "C",
      "address": "https://example.org/c/1-a/1.1-x.html", "feed": "../feed.xml",
      "search": "../opensearch.xml",
      "picture": {"address": "https://example.org/c/1-a/1.1-x/lab-1.png",
                  "width": 4, "height": 2, "alt": "A lab"}})"));
  EXPECT_EQ(facts.find('<'), facts.npos) << facts;
  EXPECT_EQ(json::parse(facts), json::parse(R"({
      "@context": "https://schema.org", "@type": "LearningResource",
      "learningResourceType": "lesson", "name": "1.1 </script>", "description": "What",
      "url": "https://example.org/c/1-a/1.1-x.html", "inLanguage": "en", "timeRequired": "PT20M",
      "dateModified": "2026-03-04T04:30:00Z",
      "isPartOf": {"@type": "Course", "name": "C", "url": "https://example.org/c/"}})"));
}

TEST(WebPlace, OfTheHomePageIsTheSites) {
  SiteOf site;
  site.course.url = "https://example.org/c/";
  const json place = web_place(site.data, "index.html", {"home", "C", "What"});
  EXPECT_EQ(place["address"], "https://example.org/c/");
  EXPECT_EQ(place["kind"], "website");
  EXPECT_EQ(place["feed"], "");
  EXPECT_EQ(json::parse(place["facts"].get<std::string>())["@type"], "Course");
}

TEST(WebPlace, OfOtherPagesTellsNoFacts) {
  SiteOf site;
  site.course.url = "https://example.org/c/";
  const json place = web_place(site.data, "models/a b.html", {"model", "a b", "What", "../"});
  EXPECT_EQ(place["address"], "https://example.org/c/models/a%20b.html");
  EXPECT_EQ(place["facts"], "");
}

}  // namespace
}  // namespace mjcourse
