#include "course/reference_picture.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

// What is said of a course whose one lesson has this body, with two pictures beside it.
std::string said_of(const std::string& body) {
  const MemoryFiles files(
      {{"content/course.yaml", "title: C\nlevels: [{folder: 1-a, title: A, lessons: [1.1-x]}]\n"},
       {"content/1-a/1.1-x.md", "---\ntitle: T\n---\n" + body},
       {"content/1-a/pictures/1.1-arm.png", "bytes"},
       {"content/1-a/pictures/1.1-leg.png", "bytes"},
       {"content/1-a/pictures/notes.txt", "bytes"}});
  Diagnostics diagnostics;
  read_course(files, diagnostics);
  return shown(diagnostics);
}

std::string pinned(const std::string& name) {
  return "```figure\n{\"model\": \"m\", \"alt\": \"A.\", \"pin\": \"" + name + "\"}\n```\n";
}

TEST(ReferencePicture, LiesBesideItsLesson) {
  const ReadingOf reading = reading_of("Text.\n");
  EXPECT_EQ(reference_path(*reading.lesson, "arm"), "content/1-a/pictures/1.1-arm.png");
}

TEST(ReferencePicture, ThatNoLessonPinsIsWarnedOf) {
  EXPECT_EQ(said_of(pinned("arm") + pinned("leg")), "");
  EXPECT_EQ(said_of(pinned("leg")),
            "content/1-a/pictures/1.1-arm.png: warning: no lesson pins this picture any more "
            "[W-picture-unused]\n  cure: remove the file\n");
}

TEST(ReferencePicture, IsNotSpokenOfBesideAMistake) {
  const std::string mistakes = said_of(pinned("arm") + "```figure\n{\n```\n");
  EXPECT_NE(mistakes.find("E-json-syntax"), std::string::npos) << mistakes;
  EXPECT_EQ(mistakes.find("W-picture-unused"), std::string::npos) << mistakes;
}

}  // namespace
}  // namespace mjcourse
