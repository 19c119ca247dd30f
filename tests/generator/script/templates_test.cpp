#include "script/templates.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bundle.h"

namespace mjcourse {

class TemplatesTest : public testing::Test {
 protected:
  // What `name` renders to, or "name:line: message" of its mistake.
  std::string render(const std::string& name, const nlohmann::json& data) {
    const auto html = templates_.render(name, data);
    if (html) return *html;
    const auto& [where, message, line, cure] = html.error();
    return where + ":" + std::to_string(line) + ": " + message;
  }

  Templates templates_{bundle("templates"),
                       {{"page", "<h1>{{title}}</h1>\n{{#each parts}}{{> part}}{{/each}}"},
                        {"part", "<p>\n{{name}}{{#if bold}}!{{/if}}\n</p>"},
                        {"raw", "{{{html}}}"},
                        {"broken", "one\n{{#if a}}\ntwo"},
                        {"lost", "\n{{> nowhere}}"}}};
};

TEST_F(TemplatesTest, FillsInAndEscapes) {
  EXPECT_EQ(render("page", {{"title", "a < b"}, {"parts", nlohmann::json::array()}}),
            "<h1>a &lt; b</h1>\n");
  EXPECT_EQ(render("raw", {{"html", "<b>é</b>"}}), "<b>é</b>");
}

TEST_F(TemplatesTest, TemplatesIncludeEachOther) {
  EXPECT_EQ(render("page", {{"title", "t"}, {"parts", {{{"name", "x"}, {"bold", true}}}}}),
            "<h1>t</h1>\n<p>\nx!\n</p>");
}

TEST_F(TemplatesTest, AMissingNameIsAnErrorInItsOwnTemplate) {
  EXPECT_EQ(render("page", {{"titel", "t"}}), "page:1: \"title\" is not in the data");
  EXPECT_EQ(render("page", {{"title", "t"}, {"parts", {{{"bold", true}}}}}),
            "part:2: \"name\" is not in the data");
  EXPECT_EQ(render("page", {{"title", "t"}, {"parts", {{{"name", "x"}}}}}),
            "part:2: \"bold\" is not in the data");
}

TEST_F(TemplatesTest, BrokenTemplatesAreErrors) {
  EXPECT_EQ(render("broken", {{"a", 1}}),
            "broken:3: Expecting 'OPEN_INVERSE_CHAIN', 'INVERSE', 'OPEN_ENDBLOCK', got 'EOF'");
  EXPECT_EQ(render("lost", {{"a", 1}}), "lost:0: The partial nowhere could not be found");
  EXPECT_EQ(render("absent", {{"a", 1}}), "absent:0: there is no such template");
}

// Each ends, whatever it is asked for, with its name.
TEST(HostileTemplates, AreBounded) {
  std::map<std::string, std::string> sources{
      {"itself", "{{> itself}}"},
      {"loops",
       "{{#each all}}{{#each @root.all}}{{#each @root.all}}{{@root.text}}{{/each}}"
       "{{/each}}{{/each}}"},
      {"text", "{{#each all}}{{{@root.text}}}{{/each}}"},
      {"p12", "{{{text}}}"}};
  for (int i = 0; i < 12; ++i) {
    const std::string next = "{{> p" + std::to_string(i + 1) + "}}";
    sources["p" + std::to_string(i)] = next + next;
  }
  Templates templates(bundle("templates"), sources);
  const nlohmann::json all(1000, 0);
  const auto said = [&](const std::string& name, std::size_t letters) {
    const auto html = templates.render(name, {{"all", all}, {"text", std::string(letters, 'a')}});
    if (html) return std::to_string(html->size());
    return html.error().name + ": " + html.error().message + "; " + html.error().cure;
  };
  const std::string much =
      ": makes more than 128 MiB of a page; look for a loop in a loop, and for a template that "
      "includes another one twice";
  EXPECT_EQ(said("text", 100'000), "100000000");
  EXPECT_EQ(said("text", 200'000), "text" + much);
  EXPECT_EQ(said("loops", 1'000), "loops" + much);
  EXPECT_EQ(said("p0", 1'000), "4096000");
  EXPECT_EQ(said("p0", 40'000), "p0" + much);
  EXPECT_EQ(said("itself", 0), "itself: Maximum call stack size exceeded.; ");
  EXPECT_EQ(said("text", 1), "1000");
}

TEST_F(TemplatesTest, RemembersEachTemplateAndItsDataApart) {
  for (int pass = 0; pass < 2; ++pass) {
    for (int n = 0; n < 300; ++n) {
      const std::string text = std::to_string(n);
      EXPECT_EQ(render("raw", {{"html", text}}), text);
      EXPECT_EQ(render("part", {{"name", text}, {"bold", true}}), "<p>\n" + text + "!\n</p>");
    }
  }
}

}  // namespace mjcourse
