#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

// Each picture of a lesson with this body.
std::string images(const std::string& body) {
  const ReadingOf reading = reading_of(body);
  std::string text = underlined_mistakes(reading);
  for (const Image* image : reading.all<Image>()) {
    text += reading.place(image->file) + " " + image->file.text + ", " + image->alt + ", \"" +
            image->title + "\"" + (image->alone ? ", alone\n" : "\n");
  }
  return text;
}

TEST(Image, HasAFileWordsAndAnOrigin) {
  EXPECT_EQ(images("![An *arm*](arm.png \"By hand\")\n"),
            "4:13 arm.png, An arm, \"By hand\", alone\n");
  EXPECT_EQ(images("![a](<x y.svg>) ![b](b/c.webp)\n"),
            "4:7 x y.svg, a, \"\"\n4:22 b/c.webp, b, \"\"\n");
  EXPECT_EQ(images("![a.png](a.png)\n"), "4:10 a.png, a.png, \"\", alone\n");
}

TEST(Image, MayBeNamedWithEscapes) {
  EXPECT_EQ(images("![a](my%20arm.png)\n"), "4:6 my arm.png, a, \"\", alone\n");
  EXPECT_EQ(images("![a](50%25.png)\n"), "4:6 50%.png, a, \"\", alone\n");
  EXPECT_EQ(images("![a](50%.png)\n"), "4:6 50%.png, a, \"\", alone\n");
  EXPECT_EQ(images("![a](%C3%BC.png)\n"), "4:6 \xC3\xBC.png, a, \"\", alone\n");
  // No name has these.
  EXPECT_EQ(images("![a](a%00%FF.png)\n"), "4:6 a%00%FF.png, a, \"\", alone\n");
  EXPECT_EQ(
      images("![a](%2e%2e/a.png)\n"),
      "E-image-place <%2e%2e/a.png> a picture lies in the folder of its lesson, or below it | "
      "put the file there\n");
}

TEST(Image, HasNoBlankInItsNameThatMarkdownTakesForTheEnd) {
  const auto refused = [](const std::string& name) {
    return "E-image-blank <" + name +
           "> Markdown reads this as text, since the name has a space in it | write `(<" + name +
           ">)`\n";
  };
  EXPECT_EQ(images("![a](my arm.png)\n"), refused("my arm.png"));
  EXPECT_EQ(images("![a](my arm.JPG \"By hand\")\n"), refused("my arm.JPG"));
  EXPECT_EQ(images("See [it](my arm.webp).\n"), refused("my arm.webp"));
  EXPECT_EQ(images("![*a*](my it's.svg)\n"), refused("my it's.svg"));
  EXPECT_EQ(images("`![a](my arm.png)` and (see arm.png)\n"), "");
}

TEST(Image, IsAloneOnlyAsAParagraphOfTheText) {
  EXPECT_EQ(images("> [!note] ![a](a.png)\n>\n> ![b](b.png)\n"),
            "4:16 a.png, a, \"\"\n6:8 b.png, b, \"\", alone\n");
  EXPECT_EQ(images("| ![a](a.png) |\n|---|\n"), "4:8 a.png, a, \"\"\n");
  EXPECT_EQ(images("```io\nINPUT: ![a](a.png)\n```\n"), "5:13 a.png, a, \"\"\n");
  EXPECT_EQ(images("[![a](a.png)](https://a.example)\n"), "4:7 a.png, a, \"\"\n");
}

TEST(Image, MustSayWhatItShows) {
  EXPECT_EQ(images("![](a.png)\n"),
            "E-image-alt <a.png> this picture says nothing to readers who cannot see it | say in "
            "words what "
            "it shows: `![words](a.png)`\n");
}

TEST(Image, LiesBesideItsLesson) {
  const std::string outside =
      " a picture lies in the folder of its lesson, or below it | put the file there\n";
  EXPECT_EQ(images("![a](../a.png)\n"), "E-image-place <../a.png>" + outside);
  EXPECT_EQ(images("![a](b/../../a.png)\n"), "E-image-place <b/../../a.png>" + outside);
  EXPECT_EQ(images("![a](/a.png)\n"), "E-image-place </a.png>" + outside);
  EXPECT_EQ(images("![a](a..b.png)\n"), "4:6 a..b.png, a, \"\", alone\n");
}

}  // namespace
}  // namespace mjcourse
