#include "physics/mistakes/whole_mjcf.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(WholeMjcf, PutsEachElementOnALineOfItsOwn) {
  const std::map<std::string, std::string> files{
      {"models/part.xml", "<x>\n<geom\n size='1 &lt;\n2'/><include file='part.xml'/></x>"},
      {"models/bad.xml", "<x>"}};
  const WholeMjcf whole = whole_mjcf(
      "models/main.xml",
      "<mujoco>\n <worldbody><!-- <body/> -->\n<include file='part.xml'/><site/></worldbody>\n"
      "<include file='bad.xml'/></mujoco>",
      [&](const std::string& path) { return files.contains(path) ? files.at(path) : ""; });
  EXPECT_EQ(whole.text,
            "<mujoco>\n<worldbody>\n<geom size=\"1 &lt; 2\"></geom>\n<site></site></worldbody>"
            "</mujoco>");
  ASSERT_EQ(whole.elements.size(), 4u);
  EXPECT_TRUE(whole.includes);
  EXPECT_EQ(whole.elements[2].name, "geom");
  EXPECT_EQ(whole.elements[2].file, "models/part.xml");
  EXPECT_EQ(whole.elements[2].line, 2);
  EXPECT_EQ(whole.elements[2].attributes.at("size"), "1 <\n2");
  EXPECT_EQ(whole.elements[3].file, "models/main.xml");
  EXPECT_EQ(whole.elements[3].line, 3);
}

TEST(WholeMjcf, IsNothingOfWhatIsNoXml) {
  EXPECT_TRUE(whole_mjcf("m.xml", "words", [](const auto&) { return ""; }).elements.empty());
}

}  // namespace
}  // namespace mjcourse
