#include "page/html/lesson_pictures.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

constexpr const char* kSwingFigure =
    "```figure\n{\"model\": \"m\", \"alt\": \"A figure.\"}\n```\n\n";
constexpr const char* kSwingLab =
    "```lab simlab\n{\"title\": \"T\", \"model\": \"m\", \"alt\": \"A lab.\"}\n```\n\n";

struct Shown {
  explicit Shown(const std::string& body) : reading(reading_of(body)) {
    EXPECT_EQ(reading.mistakes(), "");
    const std::vector<Block>& blocks = reading.lesson.value().blocks;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const Poster poster{Blob("webp"), Blob("png"), 320, 200};
      if (std::holds_alternative<Figure>(blocks[i])) {
        results.of_block[i] = FigureResult{poster, Blob()};
      } else {
        LabResult lab;
        lab.poster = poster;
        results.of_block[i] = lab;
      }
    }
  }
  std::string shared() const {
    const auto picture = shared_picture(reading.lesson.value(), results);
    return picture ? picture->path + " " + std::to_string(picture->width) + "x" +
                         std::to_string(picture->height) + " " + picture->alt
                   : "none";
  }

  ReadingOf reading;
  LessonResults results;
};

TEST(LessonPictures, AreInTheOrderOfTheBlocks) {
  const Shown lesson(std::string(kSwingFigure) + kSwingLab + kSwingFigure);
  const auto pictures = pictures_of(lesson.reading.lesson.value(), lesson.results);
  ASSERT_EQ(pictures.size(), 3U);
  EXPECT_EQ(pictures[0].path, "1-a/1.1-x/figure-1");
  EXPECT_NE(pictures[0].film, nullptr);
  EXPECT_EQ(pictures[1].path, "1-a/1.1-x/lab-1");
  EXPECT_EQ(pictures[1].film, nullptr);
  EXPECT_EQ(pictures[1].alt, "A lab.");
  EXPECT_EQ(pictures[2].path, "1-a/1.1-x/figure-2");
}

TEST(LessonPictures, TheForemostIsTheFirstLabsOrElseTheFirstFigures) {
  EXPECT_EQ(Shown(std::string(kSwingFigure) + kSwingLab + kSwingLab).shared(),
            "1-a/1.1-x/lab-1.png 640x400 A lab.");
  EXPECT_EQ(Shown(std::string(kSwingFigure) + kSwingFigure).shared(),
            "1-a/1.1-x/figure-1.png 640x400 A figure.");
  EXPECT_EQ(Shown("Text.\n").shared(), "none");
}

// A lab that failed has no picture, and neither has a figure.
TEST(LessonPictures, AreThoseThatWereDrawn) {
  Shown lesson(std::string(kSwingLab) + kSwingFigure + kSwingFigure);
  std::get<LabResult>(lesson.results.of_block.at(0)).poster.reset();
  lesson.results.of_block.erase(1);
  EXPECT_EQ(lesson.shared(), "1-a/1.1-x/figure-2.png 640x400 A figure.");
}

}  // namespace
}  // namespace mjcourse
