#include "lesson/blocks/read_figure.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

ReadingOf figure_reading(const std::string& json) {
  return reading_of("```figure\n" + json + "\n```\n");
}

// What is wrong with a figure that has these keys too.
std::string figure_mistakes(const std::string& keys) {
  return underlined_mistakes(figure_reading(R"({"model": "m", "alt": "A.", )" + keys + "}"));
}

TEST(Figure, ReadsAllThatItTakes) {
  const ReadingOf reading = figure_reading(R"({"model": "zoo", "alt": "An arm.",
  "camera": {"azimuth": 10, "target": [0, 0.5, 1]}, "overlays": {"frames": true},
  "keyframe": "home", "run": ["a();", "b();"], "seconds": 1.5, "size": [320, 200],
  "caption": "Of $q$ and `{zoo} nq`.", "animate": {"seconds": 2, "fps": 10}, "pin": "at-rest-2"})");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& figure = reading.only<Figure>();
  EXPECT_EQ(figure.model.text + " " + figure.alt, "zoo An arm.");
  EXPECT_EQ(figure.camera.value().azimuth, 10);
  EXPECT_EQ(figure.camera->target[1], 0.5);
  EXPECT_TRUE(figure.overlays.at(0).on);
  EXPECT_EQ(figure.keyframe.text + " " + figure.run.text, "home a();\nb();");
  EXPECT_EQ(figure.seconds, 1.5);
  EXPECT_EQ(figure.width, 320);
  EXPECT_EQ(figure.height, 200);
  EXPECT_EQ(figure.animation.value().frames(), 20);
  EXPECT_EQ(figure.pin.text, "at-rest-2");
  EXPECT_EQ(reading.only<Math>().tex.text, "q");
  EXPECT_EQ(reading.only<InlineValue>().expression.text, "nq");
}

TEST(Figure, NeedsLittle) {
  const ReadingOf reading = figure_reading(R"({"model": "zoo", "alt": "An arm."})");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& figure = reading.only<Figure>();
  EXPECT_EQ(figure.width, 640);
  EXPECT_EQ(figure.height, 400);
  EXPECT_FALSE(figure.camera || figure.from || figure.animation);
  EXPECT_EQ(figure_reading(R"({"model": "m", "alt": "A.", "animate": {"seconds": 1}})")
                .only<Figure>()
                .animation->rate,
            30);
}

TEST(Figure, TakesTheStateOfAnExample) {
  const ReadingOf reading =
      figure_reading(R"({"model": "zoo", "alt": "A.", "from": "fall/after"})");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& from = reading.only<Figure>().from.value();
  EXPECT_EQ(from.example.text + " " + from.name.text, "fall after");
  EXPECT_EQ(reading.place(from.example) + " " + reading.place(from.name), "5:40 5:45");
  for (const std::string odd : {"fall", "/after", "fall/"}) {
    EXPECT_EQ(figure_mistakes(R"("from": ")" + odd + "\""),
              "E-figure-from <" + odd +
                  "> \"from\" names an example and its snapshot | as in \"EXAMPLE/SNAPSHOT\"\n");
  }
  EXPECT_EQ(
      figure_mistakes(R"("from": "fall/after", "run": "a")"),
      "E-figure-from <\"a\"> \"from\" is the state already: a figure with it has no \"run\" | "
      "let the example go on to the state that you mean, or leave out \"from\"\n");
}

TEST(Figure, RefusesSizesThatCannotBeDrawn) {
  for (const std::string size :
       {"[640]", "[640, 15]", "[1025, 400]", "[64.5, 64]", "[64, \"a\"]"}) {
    EXPECT_EQ(figure_mistakes("\"size\": " + size),
              "E-json-range <" + size +
                  "> \"size\" is a width and a height in pixels: two whole numbers from 16 to "
                  "1024 | as in [640, 400]\n");
  }
}

TEST(Figure, RefusesFilmsThatAreTooLong) {
  EXPECT_EQ(figure_mistakes(R"("animate": {"seconds": 19.2})"), "");
  EXPECT_EQ(figure_mistakes(R"("animate": {"seconds": 19.4})"),
            "E-figure-frames <{> 582 frames of 640 × 400 pixels are too many: unpacked they take "
            "1005 MB, and 1000 MB is the most | fewer \"seconds\" or \"fps\", or a smaller "
            "\"size\"\n");
  EXPECT_EQ(figure_mistakes(R"("size": [320, 200], "animate": {"seconds": 40})"), "");
}

TEST(Figure, HasAPinThatIsAFilesName) {
  EXPECT_EQ(figure_mistakes("\"pin\": \"" + std::string(100, 'a') + "\""), "");
  for (const std::string& pin : {std::string("../a"), std::string("A"), std::string("a b"),
                                 std::string("a.png"), std::string(101, 'a')}) {
    EXPECT_EQ(figure_mistakes("\"pin\": \"" + pin + "\""),
              "E-pin-name <" + pin +
                  "> \"pin\" names a picture's file: small letters, digits and hyphens, "
                  "100 at most | as in \"arm-at-rest\"\n");
  }
}

// A lab's poster and a figure are pinned alike.
TEST(Figure, HasAPinOfItsOwn) {
  const ReadingOf reading = reading_of(
      "```lab simlab\n{\"title\": \"T\", \"model\": \"m\", \"alt\": \"A.\", \"pin\": "
      "\"arm\"}\n```\n"
      "```figure\n{\"model\": \"m\", \"alt\": \"A.\", \"pin\": \"arm\"}\n```\n");
  EXPECT_EQ(underlined_mistakes(reading),
            "E-pin-name <arm> another picture of this lesson is pinned as \"arm\" | give each a "
            "name of its own\n");
  EXPECT_EQ(reading.only<Lab>().pin.text, "arm");
  EXPECT_EQ(reading.only<Figure>().pin.text, "");
}

}  // namespace
}  // namespace mjcourse
