#include "lesson/unloaded_lesson.h"

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

TEST(UnloadedLesson, IsProseWhereNothingIsToBeFoundOut) {
  EXPECT_TRUE(is_prose(prose()));
  EXPECT_TRUE(is_prose_with("> [!note] A\n> text\n\n````demo\n**b**\n````\n"));
  EXPECT_FALSE(is_prose_with("$x$\n"));
  EXPECT_FALSE(is_prose_with("````demo\n$x$\n````\n"));
  EXPECT_FALSE(is_prose_with("`{zoo} model.nq`\n"));
  EXPECT_FALSE(is_prose_with("[[term]]\n"));
  EXPECT_FALSE(is_prose_with("[a](api:mj_step)\n"));
  EXPECT_FALSE(is_prose_with("[a](model:zoo)\n"));
}

TEST(UnloadedLesson, KeepsOfAnOutlineWhatOtherLessonsNeed) {
  Lesson lesson = prose();
  unload(lesson, Lesson::Kept::outline);
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

TEST(UnloadedLesson, KeepsTheBlocksOfWhatIsEvaluated) {
  Lesson lesson = prose();
  unload(lesson, Lesson::Kept::blocks);
  forget_links(lesson);
  EXPECT_EQ(lesson.blocks.size(), 1U);
  EXPECT_EQ(lesson.links.size(), 1U);
  EXPECT_EQ(lesson.source->text(), kText);
  EXPECT_EQ(lesson.document, nullptr);
  EXPECT_TRUE(lesson.block_of.empty());
}

TEST(UnloadedLesson, IsAllThereOnceItIsReloaded) {
  for (const Lesson::Kept kept : {Lesson::Kept::blocks, Lesson::Kept::outline}) {
    Lesson lesson = prose();
    lesson.index = 3;
    unload(lesson, kept);
    const Lesson whole = reload(lesson, files_with(kText));
    EXPECT_EQ(whole.kept, Lesson::Kept::all);
    EXPECT_EQ(whole.index, 3U);
    EXPECT_EQ(whole.blocks.size(), 1U);
    EXPECT_EQ(whole.block_of.size(), 1U);
    EXPECT_EQ(plain_text(whole.front.summary.get()), "S");
    EXPECT_EQ(plain_text(whole.headings.at(0).node), "One");
  }
}

TEST(UnloadedLesson, IsNotReloadedFromAFileThatWasChanged) {
  Lesson lesson = prose();
  unload(lesson, Lesson::Kept::outline);
  const auto message = [&](const MemoryFiles& files) {
    try {
      reload(lesson, files);
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
