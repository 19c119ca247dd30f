#include "evaluate/scenes/image.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

constexpr const char* kSvg = "<svg width='3' height='2'/>";

TEST(Image, KnowsItsFileAndItsSize) {
  const EvaluationOf found("![a](b/a.svg)\n", {{"content/1-a/b/a.svg", kSvg}});
  EXPECT_EQ(found.mistakes(), "");
  const auto& image = found.result<ImageResult>();
  EXPECT_EQ(image.width * 10 + image.height, 32);
  EXPECT_TRUE(image.file.string().ends_with("content/1-a/b/a.svg"));
  EXPECT_EQ(image.hash.size(), 10U);
}

TEST(Image, MustBeThere) {
  EXPECT_EQ(
      evaluated_mistakes("![a](b/aa.svg)\n", {{"content/1-a/b/a.svg", kSvg}}),
      R"(content/1-a/1.1-x.md:4:6: error: there is no file content/1-a/b/aa.svg [E-image-missing]
  4 | ![a](b/aa.svg)
    |      ^~~~~~~~
  cure: did you mean `b/a.svg`?
)");
}

TEST(Image, MustBeWhatItsNameSays) {
  EXPECT_EQ(evaluated_mistakes("![a](a.png)\n", {{"content/1-a/a.png", kSvg}}),
            R"(content/1-a/1.1-x.md:4:6: error: content/1-a/a.png is not a PNG [E-image-broken]
  4 | ![a](a.png)
    |      ^~~~~
  cure: save it again
)");
}

TEST(Image, BringsNoScript) {
  EXPECT_EQ(
      evaluated_mistakes(
          "![a](a.svg)\n",
          {{"content/1-a/a.svg", "<svg width='3' height='2'>\n  <g onclick='x()'/>\n</svg>"}}),
      R"--(content/1-a/a.svg:2:6: error: a drawing cannot have the attribute `onclick` [E-image-svg]
  2 |   <g onclick='x()'/>
    |      ^~~~~~~
  note: content/1-a/1.1-x.md:4:6: lesson content/1-a/1.1-x.md shows this drawing
  4 | ![a](a.svg)
    |      ^~~~~
  cure: use only elements that draw; most programs can save a "plain" SVG, which has nothing else
)--");
}

// Before its XML is read, which would take minutes.
TEST(Image, IsNoDrawingOfManyAttributes) {
  std::string many;
  for (int i = 0; i < 300; ++i) many += " x='1'";
  EXPECT_EQ(evaluated_mistakes("![a](a.svg)\n", {{"content/1-a/a.svg", "<svg>\n<g" + many + "/>"}})
                .substr(0, 103),
            "content/1-a/a.svg:2:1: error: an element of a drawing has at most 200 attributes "
            "[E-image-svg]\n  2 | <g");
}

}  // namespace
}  // namespace mjcourse
