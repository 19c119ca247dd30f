#include "evaluate/scenes/image.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

constexpr const char* kSvg = "<svg xmlns='http://www.w3.org/2000/svg' width='3' height='2'/>";

std::string mistakes_of_drawing(const std::string& bytes) {
  return evaluated_mistakes("![a](a.svg)\n", {{"content/1-a/a.svg", bytes}});
}

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

TEST(Image, MustSayHowLargeItIs) {
  EXPECT_EQ(
      mistakes_of_drawing("<svg xmlns='http://www.w3.org/2000/svg'/>"),
      R"(content/1-a/1.1-x.md:4:6: error: content/1-a/a.svg is not an SVG that states its size by width and height in pixels or by its viewBox [E-image-broken]
  4 | ![a](a.svg)
    |      ^~~~~
  cure: give its `<svg>` a `viewBox`
)");
}

// Before its size is asked for, of which nobody can tell then.
TEST(Image, MustBeXmlWhereItIsADrawing) {
  EXPECT_EQ(
      mistakes_of_drawing("<svg xmlns='http://www.w3.org/2000/svg'>\n  <g>&nbsp;</g>\n</svg>"),
      R"(content/1-a/a.svg:2:6: error: the drawing is not XML: it has no character `&nbsp;` [E-image-svg]
  2 |   <g>&nbsp;</g>
    |      ^~~~~~
  note: content/1-a/1.1-x.md:4:6: lesson content/1-a/1.1-x.md shows this drawing
  4 | ![a](a.svg)
    |      ^~~~~
  cure: write the character itself, or its number, as `&#160;`
)");
}

TEST(Image, BringsNoScript) {
  EXPECT_EQ(
      mistakes_of_drawing("<svg xmlns='http://www.w3.org/2000/svg'>\n  <g onclick='x()'/>\n</svg>"),
      R"--(content/1-a/a.svg:2:6: error: a drawing cannot have the attribute `onclick` [E-image-svg]
  2 |   <g onclick='x()'/>
    |      ^~~~~~~
  note: content/1-a/1.1-x.md:4:6: lesson content/1-a/1.1-x.md shows this drawing
  4 | ![a](a.svg)
    |      ^~~~~
  cure: use only elements that draw; most programs can save a "plain" SVG, which has nothing else
)--");
}

// Before its XML is read, all of whose attributes are kept at once.
TEST(Image, IsNoDrawingOfManyAttributes) {
  std::string many;
  for (int i = 0; i < 300; ++i) many += " x='1'";
  EXPECT_EQ(mistakes_of_drawing("<svg>\n<g" + many + "/>").substr(0, 103),
            "content/1-a/a.svg:2:1: error: an element of a drawing has at most 200 attributes "
            "[E-image-svg]\n  2 | <g");
}

}  // namespace
}  // namespace mjcourse
