#include "evaluate/scenes/figure.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"
#include "physics/picture.h"

namespace mjcourse {
namespace {

// A small figure of the ball with these keys too; its line 6 is theirs.
std::string figure_text(const std::string& keys) {
  return "```figure\n{\"model\": \"ball\", \"alt\": \"A ball.\", \"size\": [64, 40],\n" + keys +
         "}\n```\n";
}

std::string png_of(const std::string& keys) {
  const EvaluationOf found(figure_text(keys));
  EXPECT_EQ(found.mistakes(), "");
  return found.result<FigureResult>().poster.png.bytes();
}

constexpr const char* kSide =
    R"("camera": {"azimuth": 90, "elevation": 0, "distance": 3, "target": [0, 0, 0.5]})";

TEST(Figure, IsDrawnAtTwiceItsSize) {
  const EvaluationOf found(figure_text(kSide));
  EXPECT_EQ(found.mistakes(), "");
  const auto& result = found.result<FigureResult>();
  EXPECT_EQ(result.poster.width, 64);
  EXPECT_EQ(result.poster.height, 40);
  EXPECT_EQ(result.poster.webp.bytes().substr(8, 4), "WEBP");
  const Picture picture = decode_png(result.poster.png.bytes()).value();
  EXPECT_EQ(picture.width, 128);
  EXPECT_EQ(picture.height, 80);
  EXPECT_TRUE(result.film.empty());
  EXPECT_EQ(found.tally().pictures, 1);
}

// The script comes after the keyframe, and time after the script.
TEST(Figure, ShowsTheStateThatItNames) {
  const std::string at_rest = png_of(kSide);
  const std::string lifted = png_of(std::string(kSide) + R"(, "run": "data.qpos[2] = 0.51")");
  EXPECT_NE(at_rest, lifted);
  const std::string fallen =
      png_of(std::string(kSide) + R"(, "run": "model.opt.gravity[2] = -0.98", "seconds": 1)");
  EXPECT_EQ(fallen, png_of(std::string(kSide) +
                           R"(, "run": ["model.opt.gravity[2] = -0.98;", "step(500);"])"));
}

std::string animated(const std::string& keys) {
  const EvaluationOf found(figure_text(std::string(kSide) + keys));
  EXPECT_EQ(found.mistakes(), "");
  return found.result<FigureResult>().film.bytes();
}

TEST(Figure, IsTheSameFilmEachTime) {
  const std::string film = animated(R"(, "animate": {"seconds": 0.3, "fps": 10})");
  EXPECT_EQ(film.substr(4, 4), "ftyp");
  EXPECT_EQ(film, animated(R"(, "animate": {"seconds": 0.3, "fps": 10})"));
  EXPECT_NE(film, animated(R"(, "seconds": 0.1, "animate": {"seconds": 0.3, "fps": 10})"));
}

// Where the ball flies in the film, from the same state.
TEST(Figure, SeesWhereTheFilmLeads) {
  const std::string thrown = R"("run": "data.qvel[2] = 4")";
  EXPECT_NE(png_of(thrown), png_of(thrown + R"(, "animate": {"seconds": 0.3, "fps": 10})"));
  EXPECT_EQ(png_of(kSide + (", " + thrown)),
            png_of(kSide + (", " + thrown + R"(, "animate": {"seconds": 0.3, "fps": 10})")));
}

}  // namespace
}  // namespace mjcourse
