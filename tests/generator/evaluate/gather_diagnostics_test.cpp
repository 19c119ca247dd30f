#include "evaluate/gather_diagnostics.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// A mistake of a model, found for a lesson.
Diagnostic mistake_of(const std::string& id, int line, const std::string& lesson) {
  Diagnostic one = error_at({"models/m.xml", line, 1, 1, ""}, id, "wrong");
  if (!lesson.empty()) one.notes = {{"used here", {lesson, 5, 0, 1, ""}}};
  return one;
}

// "E-x@2(a.md b.md )" for each diagnostic: its line and the lessons of its notes.
std::string gathered(const std::vector<Diagnostics>& found) {
  Diagnostics all;
  for (const Diagnostics& one : found) gather_diagnostics(one, all);
  std::string text;
  for (const Diagnostic& one : all) {
    text += one.id + "@" + std::to_string(one.place.line) + "(";
    for (const Note& note : one.notes) text += note.place.file + " ";
    text += ")";
  }
  return text;
}

TEST(GatherDiagnostics, TellsAMistakeOfASharedFileOnceWithEachLesson) {
  for (const std::string id : {"E-model-mjcf", "E-example-compile", "W-example-compile"}) {
    EXPECT_EQ(gathered({{mistake_of(id, 2, "a.md")},
                        {mistake_of(id, 2, "b.md"), mistake_of(id, 2, "a.md")}}),
              id + "@2(a.md b.md )");
  }
}

TEST(GatherDiagnostics, TellsEachMistakeAtItsPlace) {
  EXPECT_EQ(
      gathered({{mistake_of("E-model-mjcf", 2, "a.md")}, {mistake_of("E-model-mjcf", 3, "b.md")}}),
      "E-model-mjcf@2(a.md )E-model-mjcf@3(b.md )");
}

// A mistake of one lesson stays one of each that has it.
TEST(GatherDiagnostics, TellsTwiceWhatIsOfNoSharedFile) {
  EXPECT_EQ(gathered({{mistake_of("E-x", 2, "a.md")}, {mistake_of("E-x", 2, "a.md")}}),
            "E-x@2(a.md )E-x@2(a.md )");
  EXPECT_EQ(gathered({{mistake_of("E-model-mjcf", 2, ""), mistake_of("E-model-mjcf", 2, "")}}),
            "E-model-mjcf@2()E-model-mjcf@2()");
}

}  // namespace
}  // namespace mjcourse
