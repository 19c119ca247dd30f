#include "page/blocks/themed_assets.h"

#include <gtest/gtest.h>

#include "base/temporary_folder.h"
#include "reading_of.h"

namespace mjcourse {
namespace {

using Names = std::vector<std::string>;

class ThemedAssetsTest : public testing::Test {
 protected:
  ThemedAssetsTest() {
    write("assets/templates/lesson.hbs", "the site's");
    write("assets/templates/home.hbs", "the site's");
    write("assets/manifest.json", "{}");
    write("theme/lesson.hbs", "the course's");
    write("theme/badge.hbs", "the course's");
    write("theme/manifest.json", "no template");
    write("site/home.hbs", "the newest");
    write("site/lesson.hbs", "the newest");
  }
  void write(const std::string& path, const std::string& bytes) const {
    write_file(folder_.path() / path, bytes);
  }
  ThemedAssets with(const Names& folders) const {
    std::vector<std::filesystem::path> templates;
    for (const std::string& one : folders) templates.push_back(folder_.path() / one);
    return {folder_.path() / "assets", templates};
  }

  TemporaryFolder folder_;
};

TEST_F(ThemedAssetsTest, AreOfTheFirstFolderThatHasThem) {
  const ThemedAssets assets = with({"theme", "site"});
  EXPECT_EQ(assets.read("templates/lesson.hbs"), "the course's");
  EXPECT_EQ(assets.read("templates/home.hbs"), "the newest");
  EXPECT_EQ(with({}).read("templates/lesson.hbs"), "the site's");
  EXPECT_EQ(with({"missing"}).read("templates/lesson.hbs"), "the site's");
}

TEST_F(ThemedAssetsTest, AreTheSitesButForTemplates) {
  const ThemedAssets assets = with({"theme"});
  EXPECT_EQ(assets.read("manifest.json"), "{}");
  EXPECT_FALSE(assets.exists("badge.hbs"));
  EXPECT_TRUE(assets.exists("templates/badge.hbs"));
  EXPECT_FALSE(assets.exists("templates/missing.hbs"));
}

TEST_F(ThemedAssetsTest, AreListedOnce) {
  const ThemedAssets assets = with({"theme", "site"});
  const Names all{"badge.hbs", "home.hbs", "lesson.hbs", "manifest.json"};
  EXPECT_EQ(assets.list("templates"), all);
  EXPECT_EQ(assets.list_below("templates"), all);
  EXPECT_EQ(assets.list(""), Names{"manifest.json"});
}

TEST_F(ThemedAssetsTest, AMistakeStandsInTheTemplateThatWasRead) {
  write("course/theme/templates/lesson.hbs", "one\n{{#if}}\n");
  const DiskFiles course(folder_.path() / "course");
  EXPECT_EQ(shown({template_mistake({"lesson", "an if wants a value", 2}, course)}),
            "theme/templates/lesson.hbs:2:1: error: an if wants a value [E-template]\n"
            "  2 | {{#if}}\n"
            "    | ^~~~~~~\n");
  // At the end of the file, where something is missing.
  EXPECT_EQ(shown({template_mistake({"lesson", "it never ends", 9}, course)}),
            "theme/templates/lesson.hbs:3:1: error: it never ends [E-template]\n"
            "  3 | \n"
            "    | ^\n");
  EXPECT_EQ(shown({template_mistake({"home", "wrong", 4}, course)}),
            "site/press/templates/home.hbs:4: error: wrong [E-template]\n");
  EXPECT_EQ(shown({template_mistake({"lesson", "wrong", 0}, course)}),
            "theme/templates/lesson.hbs: error: wrong [E-template]\n");
  EXPECT_EQ(shown({template_mistake({"", "they take long", 0}, course)}),
            "theme/templates: error: they take long [E-template]\n");
}

}  // namespace
}  // namespace mjcourse
