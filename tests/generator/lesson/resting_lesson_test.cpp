#include "lesson/resting_lesson.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "reading_of.h"

namespace mjcourse {
namespace {

const std::string kPath = "content/1-a/1.1-x.md";
const std::string kText =
    "---\ntitle: T\nsummary: S\ntags: [t]\n---\n## One\n\nSee [two](1.2).\n\n"
    "```sh unchecked because=\"no\"\nls\n```\n";

Lesson prose() {
  return std::move(reading_of_file(kText, kPath).lesson.value());
}

MemoryFiles files_with(const std::string& text) {
  return MemoryFiles(std::map<std::string, std::string>{{kPath, text}});
}

bool is_prose_with(const std::string& body) {
  return is_prose(reading_of(body).lesson.value());
}

TEST(RestingLesson, IsProseWhereNothingIsToBeFoundOut) {
  EXPECT_TRUE(is_prose(prose()));
  EXPECT_TRUE(is_prose_with("> [!note] A\n> text\n\n````demo\n**b**\n````\n"));
  EXPECT_FALSE(is_prose_with("$x$\n"));
  EXPECT_FALSE(is_prose_with("````demo\n$x$\n````\n"));
  EXPECT_FALSE(is_prose_with("`{zoo} model.nq`\n"));
  EXPECT_FALSE(is_prose_with("[[term]]\n"));
  EXPECT_FALSE(is_prose_with("[a](api:mj_step)\n"));
  EXPECT_FALSE(is_prose_with("[a](model:zoo)\n"));
}

TEST(RestingLesson, KeepsOfACardWhatOtherLessonsNeed) {
  Lesson lesson = prose();
  put_to_rest(lesson, Lesson::Kept::card);
  EXPECT_EQ(lesson.number, "1.1");
  EXPECT_EQ(lesson.front.title.text, "T");
  EXPECT_EQ(lesson.source->path(), kPath);
  EXPECT_EQ(lesson.headings.at(0).id, "one");
  EXPECT_EQ(lesson.unchecked, 1);
  EXPECT_EQ(lesson.source->text(), "");
  EXPECT_TRUE(lesson.blocks.empty());
  EXPECT_EQ(lesson.document, nullptr);
  EXPECT_EQ(lesson.links.at(0).target.text, "1.2");
  forget_links(lesson);
  EXPECT_TRUE(lesson.links.empty());
}

TEST(RestingLesson, KeepsTheBlocksOfWhatIsEvaluated) {
  Lesson lesson = prose();
  put_to_rest(lesson, Lesson::Kept::blocks);
  forget_links(lesson);
  EXPECT_EQ(lesson.blocks.size(), 1U);
  EXPECT_EQ(lesson.links.size(), 1U);
  EXPECT_EQ(lesson.source->text(), kText);
  EXPECT_EQ(lesson.document, nullptr);
  EXPECT_TRUE(lesson.block_of.empty());
}

TEST(RestingLesson, IsAllThereOnceItIsWoken) {
  for (const Lesson::Kept kept : {Lesson::Kept::blocks, Lesson::Kept::card}) {
    Lesson lesson = prose();
    lesson.index = 3;
    put_to_rest(lesson, kept);
    const Lesson awake = wake(lesson, files_with(kText));
    EXPECT_EQ(awake.kept, Lesson::Kept::all);
    EXPECT_EQ(awake.index, 3U);
    EXPECT_EQ(awake.blocks.size(), 1U);
    EXPECT_EQ(awake.block_of.size(), 1U);
    EXPECT_EQ(plain_text(awake.front.summary.get()), "S");
    EXPECT_EQ(plain_text(awake.headings.at(0).node), "One");
  }
}

TEST(RestingLesson, IsNotWokenFromAFileThatWasChanged) {
  Lesson lesson = prose();
  put_to_rest(lesson, Lesson::Kept::card);
  const auto message = [&](const MemoryFiles& files) {
    try {
      wake(lesson, files);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message(files_with(kText + "\n")),
            kPath + " was changed while it was worked on; begin again");
  EXPECT_EQ(message(MemoryFiles(std::map<std::string, std::string>())),
            "cannot read again " + kPath + ": No such file or directory");
}

}  // namespace
}  // namespace mjcourse
