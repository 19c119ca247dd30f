#include "course/lesson_cache.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "course_of.h"

namespace mjcourse {
namespace {

constexpr const char* kX = "content/1-a/1.1-x.md";

// Two lessons, read with what is in the cache.
struct Reader {
  std::map<std::string, std::string> files{{"content/course.yaml", kTwo},
                                           {kX, lesson("## One\n\nText, and $x$.\n")},
                                           {"content/1-a/1.2-y.md", lesson("[Back](1.1#one).\n")}};
  LessonCache cache;
  Diagnostics diagnostics;

  Course read() {
    diagnostics.clear();
    return read_course(MemoryFiles(files), diagnostics, 2, kMostLoaded, &cache).value();
  }
  void read_and_give_back() {
    Course course = read();
    cache.give_back(course);
  }
};

TEST(LessonCache, GivesALessonOfTheSameTextOnce) {
  Reader reader;
  reader.read_and_give_back();
  EXPECT_FALSE(reader.cache.take(kX, "another text"));
  const std::optional<Lesson> taken = reader.cache.take(kX, reader.files.at(kX));
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->number, "1.1");
  EXPECT_EQ(taken->headings.size(), 1u);
  EXPECT_FALSE(reader.cache.take(kX, reader.files.at(kX)));
}

TEST(LessonCache, MakesTheSameCourse) {
  Reader reader;
  Course first = reader.read();
  const cmark_node* document = first.lessons[1].document.get();
  reader.cache.give_back(first);
  reader.files[kX] = lesson("## Two\n\nAnother text.\n");
  const Course second = reader.read();
  EXPECT_EQ(second.lessons[1].document.get(), document) << "it was read again";
  EXPECT_EQ(second.lessons[0].headings[0].id, "two");
  // What one lesson says of another is looked at again.
  ASSERT_EQ(reader.diagnostics.size(), 1u);
  EXPECT_EQ(reader.diagnostics[0].id, "E-link-anchor");
}

TEST(LessonCache, HasNoLessonWithAMistake) {
  Reader reader;
  reader.files[kX] = lesson("```nonsense\n```\n");
  reader.read_and_give_back();
  ASSERT_EQ(reader.diagnostics.size(), 2u);
  reader.read_and_give_back();
  EXPECT_EQ(reader.diagnostics.size(), 2u) << "the mistake was forgotten";
  EXPECT_FALSE(reader.cache.take(kX, reader.files.at(kX)));
}

TEST(LessonCache, HasNoLessonWithTheQuotesOfAnotherLanguage) {
  Reader reader;
  reader.files[kX] = lesson("## \"One\"\n");
  reader.read_and_give_back();
  reader.files["content/course.yaml"] += "language: de\n";
  EXPECT_EQ(plain_text(reader.read().lessons[0].document.get()), "„One“");
}

TEST(LessonCache, HasNoUnloadedLesson) {
  Reader reader;
  Course course =
      read_course(MemoryFiles(reader.files), reader.diagnostics, 2, 1, &reader.cache).value();
  reader.cache.give_back(course);
  EXPECT_TRUE(reader.cache.take(kX, reader.files.at(kX)));
  EXPECT_FALSE(reader.cache.take("content/1-a/1.2-y.md", reader.files.at("content/1-a/1.2-y.md")));
}

}  // namespace
}  // namespace mjcourse
