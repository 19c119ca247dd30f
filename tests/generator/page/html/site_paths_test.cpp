#include "page/html/site_paths.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

TEST(SitePaths, AreAddressesThatNeedNoEscapeInHtml) {
  EXPECT_EQ(site_address("1-a/1.1-x.html"), "1-a/1.1-x.html");
  EXPECT_EQ(site_address("a b/c?d#e%f&g\"h'i<j>.html"),
            "a%20b/c%3Fd%23e%25f%26g%22h%27i%3Cj%3E.html");
  // What begins with a word and a colon would be of another scheme.
  EXPECT_EQ(site_address("a:b.html"), "a%3Ab.html");
  EXPECT_EQ(site_address("größe/日.html"), "größe/日.html");
  EXPECT_EQ(site_address("a\tb\x7F"), "a%09b%7F");
}

TEST(SitePaths, LeadBackToTheRoot) {
  EXPECT_EQ(way_to_root("index.html"), "");
  EXPECT_EQ(way_to_root("1-a/1.1-x.html"), "../");
  EXPECT_EQ(way_to_root("models/arm/scene.html"), "../../");
}

TEST(SitePaths, OfALessonLieInItsFolder) {
  const Lesson lesson = reading_of("Text.\n").lesson.value();
  EXPECT_EQ(page_path(lesson), "1-a/1.1-x.html");
  Lesson glossary;
  glossary.slug = "glossary";
  EXPECT_EQ(page_path(glossary), "glossary.html");
}

TEST(SitePaths, OfPicturesHaveTheirHashAndNoCharacterToEscape) {
  const Lesson lesson = reading_of("Text.\n").lesson.value();
  Image image;
  image.file.text = "sub/My picture (2)é.v2.svg";
  ImageResult result;
  result.hash = "abc";
  EXPECT_EQ(image_path(lesson, image, result), "1-a/1.1-x/My-picture--2----v2-abc.svg");
}

TEST(SitePaths, OfBlocksAreNamedByTheirKind) {
  const ReadingOf reading = reading_of(
      "```figure\n{\"model\": \"a\", \"alt\": \"A.\"}\n```\n\n"
      "```figure\n{\"model\": \"b\", \"alt\": \"B.\"}\n```\n");
  EXPECT_EQ(block_path(reading.lesson.value(), 1), "1-a/1.1-x/figure-2");
}

TEST(SitePaths, OfAProgramAreThoseOfOneThatRan) {
  Example example;
  example.file.text = "examples/say.it.cpp";
  const ExampleResult result;
  EXPECT_EQ(program_zip_path(example, &result), "examples/say.it.zip");
  EXPECT_EQ(program_zip_path(example, nullptr), "");
  example.compiles = false;
  EXPECT_EQ(program_zip_path(example, &result), "");
}

TEST(SitePaths, ArePublishedWhereTheCourseIs) {
  Course course;
  EXPECT_EQ(web_address(course, "index.html"), "");
  course.url = "https://example.org/course/";
  EXPECT_EQ(web_address(course, "index.html"), "https://example.org/course/");
  EXPECT_EQ(web_address(course, "1-a/größe.html"),
            "https://example.org/course/1-a/gr%C3%B6%C3%9Fe.html");
}

}  // namespace
}  // namespace mjcourse
