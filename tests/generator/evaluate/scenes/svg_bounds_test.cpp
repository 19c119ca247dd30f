#include "evaluate/scenes/svg_bounds.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

std::string attributes(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += " data-a" + std::to_string(i) + "='=<>&'";
  return text;
}

std::string drawing(const std::string& content) {
  return "<svg xmlns='http://www.w3.org/2000/svg'>" + content + "</svg>";
}

// Where it begins, and what is said; of all that reads a drawing.
std::string excess(const std::string& bytes) {
  const auto excess = excess_of_svg(bytes);
  if (!excess) return "";
  const auto faults = faults_of_svg(bytes);
  EXPECT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults.at(0).message, excess->message);
  return bytes.substr(excess->span.begin, 2) + ": " + excess->message + "; " + excess->cure;
}

TEST(SvgBounds, OfTheAttributesOfAnElement) {
  const std::string many =
      "<g: an element of a drawing has at most 200 attributes; save it again with a program that "
      "draws";
  EXPECT_EQ(excess(drawing("<g" + attributes(200) + "/><g" + attributes(200) + "/>")), "");
  EXPECT_EQ(excess(drawing("<g" + attributes(201) + "/>")), many);
  EXPECT_EQ(excess(drawing("a<!-- <g ' --><![CDATA[ <g \" ]]><?x ' ?><g" + attributes(201) + ">")),
            many);
  EXPECT_EQ(excess("<g" + attributes(201)), many);
  for (const char* open : {"<!-- ", "<![CDATA[", "<?x ", "</g ", "<g a='", "<"}) {
    EXPECT_EQ(excess(drawing(open)), "") << open;
  }
  EXPECT_EQ(excess(drawing("<!--" + attributes(300) + "-->" + attributes(300))), "");
}

TEST(SvgBounds, OfItsBytes) {
  const std::string most(16 << 20, ' ');
  EXPECT_EQ(excess(most), "");
  EXPECT_EQ(excess(most + " "),
            "  : a drawing has at most 16 MiB; simplify it, or save it as PNG or WebP");
}

}  // namespace
}  // namespace mjcourse
