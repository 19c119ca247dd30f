#include "cli/new_part.h"

#include <gtest/gtest.h>

#include "cli/run.h"

namespace mjcourse {
namespace {

using Words = std::vector<std::string>;

// The paths of what these words make in the course, or "CODE message | cure".
Words made(const Words& words, std::map<std::string, std::string> more = {}) {
  more.insert({{"content/course.yaml",
                "title: C\nlevels:\n  - folder: 1-state\n    title: State\n    lessons: [1.2-b]\n"
                "  - folder: guide\n    title: Guide\n    lessons: [A.1-x]\n"},
               {"content/1-state/1.2-b.md", ""},
               {"content/1-state/1.7-draft.md", ""},
               {"models/box.xml", ""}});
  const MemoryFiles assets({{"skeleton/lesson.md", "@title@ @number@ @model@ @example@\n"},
                            {"skeleton/model.xml", "@name@\n"},
                            {"skeleton/example.cpp", "@name@ @model@\n"},
                            {"skeleton/exercise.cpp", "@name@ asks of @model@\n"}});
  const auto part = new_part(MemoryFiles(std::move(more)), assets, words);
  if (!part) {
    return {std::to_string(part.error().code) + " " + part.error().message + " | " +
            part.error().cure};
  }
  Words paths;
  for (const NewFile& file : part->files) paths.push_back(file.path);
  if (!part->folder.empty()) paths.push_back(part->folder + "/");
  return paths;
}

// The one file, or the refusal.
std::string one(const Words& words, std::map<std::string, std::string> more = {}) {
  const Words all = made(words, std::move(more));
  return all.front();
}

TEST(NewPart, NeedsAKind) {
  EXPECT_EQ(
      one({}),
      "2 new what? | a level, a lesson, a model, an example, an exercise or a ci, as in `mjcourse "
      "new lesson "
      "2-dynamics \"Forces\"`");
  EXPECT_EQ(one({"lesso"}), "2 new cannot make `lesso` | did you mean `lesson`?");
}

TEST(NewLevel, IsAFolderAndAnEntry) {
  EXPECT_EQ(made({"level", "2-dynamics", "Dynamics"}),
            (Words{"content/course.yaml", "content/2-dynamics/"}));
  EXPECT_EQ(made({"level", "Rigid bodies"}).back(), "content/2-rigid-bodies/");
  EXPECT_EQ(made({"level", "notes"}).back(), "content/notes/");
}

TEST(NewLevel, NeedsANameThatIsFree) {
  EXPECT_EQ(one({"level"}),
            "2 new level needs a name | as in `mjcourse new level 2-dynamics \"Dynamics\"`");
  EXPECT_EQ(one({"level", "2_Dynamics", "Dynamics"}),
            "2 `2_Dynamics` is not a name for a level | a number, then small letters, digits and "
            "hyphens, as in `mjcourse new level 2-dynamics \"Dynamics\"`; did you mean "
            "`2-dynamics`?");
  EXPECT_EQ(
      one({"level", "../x"}),
      "2 `../x` is not a name for a level | a number, then small letters, digits and hyphens, "
      "as in `mjcourse new level 2-dynamics \"Dynamics\"`; did you mean `x`?");
  const std::string another =
      " | choose another name, as in `mjcourse new level 2-dynamics \"Dynamics\"`";
  EXPECT_EQ(one({"level", "models"}),
            "2 `models` is where the site has the pages of models" + another);
  EXPECT_EQ(one({"level", "con"}), "2 `con` is a device on Windows" + another);
  EXPECT_EQ(one({"model", "arm/nul"}),
            "2 `nul` is a device on Windows | choose another name, as in `mjcourse new model "
            "pendulum`");
  EXPECT_EQ(one({"level", "2-rigid", "Rigid", "bodies"}),
            "2 new level takes a name and a title, not `bodies` | put a title of several words "
            "into quotes: `mjcourse new level 2-dynamics \"Dynamics\"`");
  EXPECT_EQ(one({"level", "2-x", "a\nb"}),
            "2 `a\\nb` is not a title | a title is one line of text");
  EXPECT_EQ(one({"level", "1-state"}),
            "1 the course has a level 1-state already | choose another name");
  EXPECT_EQ(one({"level", "1-other"}),
            "1 level 1 is there already: 1-state | the next number is 2");
}

TEST(NewLesson, IsALessonItsProgramAndItsModel) {
  EXPECT_EQ(made({"lesson", "1-state/1.3-free-fall", "Free fall"}),
            (Words{"content/1-state/1.3-free-fall.md", "examples/l1_3_free_fall.cpp",
                   "models/free_fall.xml", "content/course.yaml"}));
}

TEST(NewLesson, IsCalledInManyWays) {
  // The next number counts files that nothing lists.
  EXPECT_EQ(one({"lesson", "1-state", "Free fall"}), "content/1-state/1.8-free-fall.md");
  EXPECT_EQ(one({"lesson", "1", "Free fall"}), "content/1-state/1.8-free-fall.md");
  EXPECT_EQ(one({"lesson", "content/1-state/", "Free fall"}), "content/1-state/1.8-free-fall.md");
  EXPECT_EQ(one({"lesson", "content/1-state/1.3-a.md"}), "content/1-state/1.3-a.md");
  EXPECT_EQ(one({"lesson", "1-state/free-fall"}), "content/1-state/1.8-free-fall.md");
  EXPECT_EQ(one({"lesson", "1.3-free-fall"}), "content/1-state/1.3-free-fall.md");
  EXPECT_EQ(one({"lesson", "guide", "More"}), "content/guide/A.2-more.md");
  EXPECT_EQ(made({"lesson", "guide", "3D"}),
            (Words{"content/guide/A.2-3d.md", "examples/la_2_3d.cpp", "models/model_3d.xml",
                   "content/course.yaml"}));
}

TEST(NewLesson, OfAnEmptyLevelWithoutANumberGetsALetterOfItsOwn) {
  EXPECT_EQ(one({"lesson", "notes", "More"},
                {{"content/course.yaml",
                  "levels:\n  - {folder: guide, lessons: [A.1-x]}\n  - {folder: notes, lessons: []}"
                  "\n"}}),
            "content/notes/B.1-more.md");
}

TEST(NewLesson, NeedsALevelANameAndAFreeNumber) {
  EXPECT_EQ(one({"lesson"}),
            "2 new lesson needs a level and a title | `mjcourse new lesson 2-dynamics \"Forces\"` "
            "takes the level's next number, `mjcourse new lesson 2-dynamics/2.1-forces \"Forces\"` "
            "names all of it");
  EXPECT_EQ(one({"lesson", "1-state"}),
            "2 a lesson of 1-state needs a title | `mjcourse new lesson 1-state \"TITLE\"`");
  EXPECT_EQ(one({"lesson", "1-stat", "Forces"}),
            "2 there is no level 1-stat in content/course.yaml | did you mean `1-state`?");
  EXPECT_EQ(one({"lesson", "2-dynamics/2.1-forces"}),
            "2 there is no level 2-dynamics in content/course.yaml | `mjcourse new level "
            "2-dynamics` makes it; known: 1-state, guide");
  EXPECT_EQ(
      one({"lesson", "3.1-forces"}),
      "2 no level in content/course.yaml has lessons with numbers such as 3.1 | name the level "
      "too: `mjcourse new lesson LEVEL/3.1-forces`; known: 1-state, guide");
  EXPECT_EQ(one({"lesson", "A.7-forces"}), "content/guide/A.7-forces.md");
  EXPECT_EQ(
      one({"lesson", "1-state/Free_Fall"}),
      "2 `1-state/Free_Fall` is not a name for a lesson | a number, then small letters, digits "
      "and hyphens, such as `2.1-forces`; did you mean `free-fall`?");
  EXPECT_EQ(one({"lesson", "1-state/2.1-forces"}),
            "2 a lesson of 1-state has a number as 1.1 | did you mean `1-state/1.8-forces`?");
  EXPECT_EQ(one({"lesson", "1-state", "Kräfte"}),
            "2 no file's name is made of `Kräfte`: it has letters that are not English, or none | "
            "name the file too, as in `mjcourse new lesson 1-state/1.8-NAME \"TITLE\"`");
  EXPECT_EQ(one({"lesson", "1-state", "Free", "fall"}),
            "2 new lesson takes a name and a title, not `fall` | put a title of several words "
            "into quotes");
  EXPECT_EQ(one({"lesson", "1-state/1.7-other"}),
            "1 the number 1.7 is taken by 1-state/1.7-draft | the next one is 1.8");
}

TEST(NewModel, IsOneFile) {
  EXPECT_EQ(made({"model", "two_rods"}), Words{"models/two_rods.xml"});
  EXPECT_EQ(made({"model", "models/two_rods.xml"}), Words{"models/two_rods.xml"});
  EXPECT_EQ(made({"model", "arm-2/scene"}), Words{"models/arm-2/scene.xml"});
  EXPECT_EQ(one({"model", "../scene"}).substr(0, 38), "2 `../scene` is not a name for a model");
  EXPECT_EQ(one({"model"}), "2 new model needs a name | as in `mjcourse new model pendulum`");
  EXPECT_EQ(one({"model", "Two-Rods"}),
            "2 `Two-Rods` is not a name for a model | small letters, digits and underscores, as in "
            "`mjcourse new model pendulum`; did you mean `two_rods`?");
  EXPECT_EQ(one({"model", "a", "b"}),
            "2 new model takes a name, not `b` | as in `mjcourse new model pendulum`");
}

TEST(NewExample, LoadsAModelOfTheCourse) {
  EXPECT_EQ(made({"example", "l1_3_fall"}), Words{"examples/l1_3_fall.cpp"});
  EXPECT_EQ(made({"example", "examples/l1_3_fall.cpp", "box"}), Words{"examples/l1_3_fall.cpp"});
  EXPECT_EQ(made({"exercise", "l1_3_mass", "box"}), Words{"examples/l1_3_mass.cpp"});
  EXPECT_EQ(one({"exercise", "1_mass"}),
            "2 `1_mass` is not a name for an exercise | small letters, digits and underscores, as "
            "in `mjcourse new exercise l2_1_forces` or `mjcourse new exercise l2_1_forces MODEL`");
  EXPECT_EQ(one({"example", "l1_3_fall", "bx"}),
            "1 there is no model bx in models/ | did you mean `box`?");
  EXPECT_EQ(
      one({"example", "1_fall"}),
      "2 `1_fall` is not a name for an example | small letters, digits and underscores, as in "
      "`mjcourse new example l2_1_forces` or `mjcourse new example l2_1_forces MODEL`");
  EXPECT_EQ(one({"example", "a", "box", "c"}),
            "2 new example takes a name and a model, not `c` | as in `mjcourse new example "
            "l2_1_forces` or `mjcourse new example l2_1_forces MODEL`");
}

TEST(NewPart, TellsOfACourseThatIsInTheWay) {
  EXPECT_EQ(one({"level", "2-x"}, {{"content/course.yaml", "levels: [\n"}}),
            "1 content/course.yaml has mistakes, so nothing was written | fix them first: "
            "`mjcourse check` shows them");
  EXPECT_EQ(one({"lesson", "1-a", "X"}, {{"content/course.yaml", "levels: [{folder: 1-a}]\n"}}),
            "1 content/course.yaml is laid out in a way that a lesson cannot be put into safely, "
            "so nothing was written | write it there yourself: `1.1-x` among the `lessons` of "
            "1-a");
}

}  // namespace
}  // namespace mjcourse
