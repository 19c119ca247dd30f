#include "page/html/lesson_pictures.h"
#include "page/page_fixture.h"

namespace mjcourse {
namespace {

constexpr const char* kFigure = R"(```figure
{"model": "m", "size": [64, 40], "alt": "An \"arm\"", "caption": "*C*"}
```
)";
constexpr const char* kLab =
    "```lab simlab\n{\"title\": \"T\", \"model\": \"m\", \"alt\": \"L\"}\n```\n";

class FigureDataTest : public PageWriterTest {
 protected:
  // "figure-1.webp lab-1.webp": what is written for a lesson with this body.
  std::string files(const std::string& markdown) {
    const ReadingOf reading = reading_of(markdown);
    pictures_ = pictures_of(*reading.lesson, results_);
    std::string text;
    for (const LessonPicture& picture : pictures_) text += picture.path + " ";
    return text;
  }

  std::vector<LessonPicture> pictures_;
};

TEST_F(FigureDataTest, IsAPictureWithItsCaption) {
  results_.of_block[0] = FigureResult{{Blob("webp"), Blob("png"), 64, 40}, {}};
  EXPECT_EQ(body(kFigure), R"(<figure class="figure" id="figure-1">
<picture><source type="image/webp" srcset="../1-a/1.1-x/figure-1.webp"><img src="../1-a/1.1-x/figure-1.png" width="64" height="40" alt="An &quot;arm&quot;" loading="lazy" decoding="async"></picture>
<figcaption><em>C</em></figcaption>
</figure>
)");
}

TEST_F(FigureDataTest, IsAFilmThatTheReaderStarts) {
  results_.of_block[0] = FigureResult{{Blob("webp"), Blob("png"), 64, 40}, Blob("film")};
  const std::string html = body(kFigure);
  EXPECT_NE(html.find("<video src=\"../1-a/1.1-x/figure-1.mp4\" "
                      "poster=\"../1-a/1.1-x/figure-1.webp\" width=\"64\" height=\"40\" muted loop "
                      "playsinline controls preload=\"none\" aria-label=\"An &quot;arm&quot;\">"
                      "</video>\n<picture>"),
            std::string::npos)
      << html;
}

TEST_F(FigureDataTest, IsCountedByItself) {
  const std::string text = std::string(kFigure) + "\n" + kLab + "\n" + kFigure;
  LabResult lab;
  lab.poster = Poster{Blob("webp"), Blob("png"), 712, 300};
  results_.of_block[1] = lab;
  results_.of_block[2] = FigureResult{{Blob("webp"), Blob("png"), 64, 40}, {}};
  EXPECT_EQ(files(text), "1-a/1.1-x/lab-1 1-a/1.1-x/figure-2 ");
  EXPECT_EQ(foremost(pictures_)->path, "1-a/1.1-x/lab-1");
}

TEST_F(FigureDataTest, StandsForALessonWithoutALab) {
  results_.of_block[0] = FigureResult{{Blob("webp"), Blob("png"), 64, 40}, Blob("film")};
  EXPECT_EQ(files(kFigure), "1-a/1.1-x/figure-1 ");
  EXPECT_EQ(foremost(pictures_)->film->bytes(), "film");
  EXPECT_EQ(files("Text.\n"), "");
  EXPECT_EQ(foremost(pictures_), nullptr);
}

}  // namespace
}  // namespace mjcourse
