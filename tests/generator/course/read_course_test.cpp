#include <gtest/gtest.h>

#include "course/course_of.h"
#include "lesson/unloaded_lesson.h"

namespace mjcourse {
namespace {

TEST(Course, IsReadInItsOwnOrder) {
  const CourseOf found({{"content/course.yaml", R"(title: C
description: D
language: de
macros: {\R: '\mathbb{R}', \half: 0.5}
levels:
  - {folder: 2-b, title: Second, lessons: [2.1-z]}
  - {folder: 1-a, title: First, lessons: [1.2-y, 1.1-x]}
)"},
                        {"content/1-a/1.1-x.md", lesson("")},
                        {"content/1-a/1.2-y.md", lesson("")},
                        {"content/2-b/2.1-z.md", lesson("")},
                        {"models/zoo.xml", ""},
                        {"models/zoo.txt", ""},
                        {"models/arm/arm.xml", ""}});
  EXPECT_EQ(found.mistakes(), "");
  const Course& course = *found.course;
  EXPECT_EQ(course.title + course.description + course.language, "CDde");
  EXPECT_EQ(course.macros,
            (std::map<std::string, std::string>{{"\\R", "\\mathbb{R}"}, {"\\half", "0.5"}}));
  ASSERT_EQ(course.lessons.size(), 3u);
  EXPECT_EQ(course.lessons[0].number, "2.1");
  EXPECT_EQ(course.lessons[1].number, "1.2");
  EXPECT_EQ(course.levels[1].lessons, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(course.find_lesson("1.1"), &course.lessons[2]);
  EXPECT_EQ(course.find_lesson("1.3"), nullptr);
  EXPECT_EQ(course.models, (std::vector<std::string>{"arm/arm", "zoo"}));
}

// What all texts of a lesson and of the glossary become, in a course with `keys`.
std::string texts_of(const std::string& keys) {
  const std::string front = "---\ntitle: T\nsummary: '\"a\"--b'\n---\n\n";
  const std::string quiz =
      "```quiz\n{\"id\": \"q\", \"questions\": [{\"kind\": \"numeric\", \"q\": \"'c'...\", "
      "\"answer\": "
      "1,\n\"verify\": [{\"because\": \"it is\"}]}]}\n```\n";
  const std::map<std::string, std::string> files{
      {"content/course.yaml",
       "title: C\n" + keys + "levels:\n  - {folder: 1-a, title: A, lessons: [1.1-x]}\n"},
      {"content/1-a/1.1-x.md", front + "\"d\" ![\"e\"](f.png)\n\n" + quiz},
      {"content/glossary.md", front + "## g\n\n\"h\"\n"}};
  Diagnostics mistakes;
  const MemoryFiles memory(files);
  const Course course = read_course(memory, mistakes, 1, 0).value();
  EXPECT_EQ(shown(mistakes), "");
  const Lesson lesson = reload(course.lessons[0], memory);
  std::string texts = plain_text(lesson.front.summary.get()) + " " +
                      plain_text(cmark_node_first_child(lesson.document.get()));
  for (const std::size_t i : blocks_of<Quiz>(lesson)) {
    texts += " " + plain_text(std::get<Quiz>(lesson.blocks[i]).questions[0].text.get());
  }
  return texts + " " + plain_text(course.glossary->terms[0].definition.get());
}

TEST(Course, SetsQuotesInItsLanguage) {
  EXPECT_EQ(texts_of(""), "“a”–b “d” “e” ‘c’… “h”");
  EXPECT_EQ(texts_of("language: de-AT\n"), "„a“–b „d“ „e“ ‚c‘… „h“");
  EXPECT_EQ(texts_of("language: ja\n"), "「a」–b 「d」 「e」 『c』… 「h」");
}

TEST(Course, LeavesQuotesDashesAndDotsWhereItIsToldTo) {
  EXPECT_EQ(texts_of("language: de\nsmart-punctuation: false\n"),
            "\"a\"--b \"d\" \"e\" 'c'... \"h\"");
  EXPECT_EQ(texts_of("smart-punctuation: true\n"), texts_of(""));
}

TEST(Course, HasAtMostTwentyThousandLessons) {
  std::string listed;
  for (int i = 0; i < 20'000; ++i) listed += "1.1-x, ";
  const CourseOf found({{"content/course.yaml",
                         "title: C\nlevels:\n  - folder: 1-a\n    title: A\n"
                         "    lessons: [" +
                             listed +
                             "1.2-y, 1.3-z]\n"
                             "  - {folder: 2-b, title: B, lessons: [2.1-w]}\n"},
                        {"content/1-a/1.1-x.md", lesson("")}});
  ASSERT_GT(found.diagnostics.size(), 1U);
  const Diagnostic& first = found.diagnostics[0];
  EXPECT_EQ(first.id + ": " + first.message + " | " + first.cure,
            "E-course-size: a course has at most 20000 lessons | make several courses of it");
  EXPECT_EQ(first.place.column, 15 + 140'000);
  EXPECT_EQ(found.course->lessons.size(), 1U);
  EXPECT_EQ(found.course->levels.size(), 2U);
}

// Nine lists, each nine times the one before.
TEST(Course, IsReadWhereAliasesMultiply) {
  std::string yaml = "title: C\na0: &a0 [x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 12; ++i) {
    const std::string number = std::to_string(i);
    yaml += "a" + number + ": &a" + number + " [";
    for (int k = 0; k < 9; ++k) yaml += "*a" + std::to_string(i - 1) + ", ";
    yaml += "]\n";
  }
  const CourseOf found({{"content/course.yaml", yaml + "macros: *a11\nlevels: *a11\n"}});
  EXPECT_TRUE(found.course->lessons.empty());
  EXPECT_LT(found.diagnostics.size(), 100U);
}

TEST(Course, NumbersItsLevelsByTheirFolders) {
  const CourseOf found({{"content/course.yaml", R"(title: C
levels:
  - {folder: 12-b, title: Twelfth, lessons: []}
  - {folder: guide, title: Beside, lessons: [A.1-x]}
)"},
                        {"content/guide/A.1-x.md", lesson("[x](A.1)")}});
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.course->levels[0].number, "12");
  EXPECT_EQ(found.course->levels[1].number, "");
  EXPECT_EQ(found.course->lessons[0].number, "A.1");
}

TEST(Course, NeedsItsFile) {
  const CourseOf found(CourseOf::FileMap{{"content/1-a/1.1-x.md", lesson("")}});
  EXPECT_FALSE(found.course);
  EXPECT_EQ(
      found.mistakes(),
      "content/course.yaml: error: cannot read content/course.yaml: No such file or directory "
      "[E-course-yaml]\n"
      "  cure: a course is a folder with content/course.yaml; name it with --course DIR\n");
}

TEST(Course, NeedsATitleAndLevels) {
  EXPECT_EQ(CourseOf(CourseOf::FileMap{{"content/course.yaml", "language: en\n"}}).mistakes(),
            R"(content/course.yaml:1:1: error: the course file has no `title` [E-course-yaml]
  1 | language: en
    | ^
  cure: add a line `title: …`
content/course.yaml:1:1: error: the course file has no `levels` [E-course-yaml]
  1 | language: en
    | ^
  cure: add a line `levels:` and a list
)");
}

// "line:column id message | cure" of each error in a course file.
std::string mistakes_in(const std::string& yaml) {
  const CourseOf found({{"content/course.yaml", yaml}, {"content/1-a/1.1-x.md", lesson("")}});
  std::string text;
  for (const Diagnostic& d : found.diagnostics) {
    if (d.severity != Severity::error) continue;
    text += std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + " " + d.id + " " +
            d.message + (d.cure.empty() ? "" : " | " + d.cure) + "\n";
  }
  return text;
}

TEST(Course, RefusesWhatItDoesNotKnow) {
  const std::string level = "levels: [{folder: 1-a, title: L, lessons: [1.1-x]}]\n";
  EXPECT_EQ(mistakes_in("title: C\n" + level), "");
  EXPECT_EQ(mistakes_in("title: C\nlanguag: de\n" + level),
            "2:1 E-course-yaml the course file has no key `languag` | did you mean `language`?\n");
  EXPECT_EQ(mistakes_in("title: C\nlevels: [{folder: 1-a, titel: L, title: L}]\n"),
            "2:24 E-course-yaml the level has no key `titel` | did you mean `title`?\n");
}

TEST(Course, RefusesValuesOfTheWrongType) {
  const std::string level = "levels: [{folder: 1-a, title: L, lessons: [1.1-x]}]\n";
  EXPECT_EQ(mistakes_in("title: C\nmacros: [a]\n" + level),
            "2:9 E-course-yaml `macros` must be a mapping: `name: text` lines\n");
  EXPECT_EQ(mistakes_in("title: C\nmacros: {a: [b]}\n" + level),
            "2:10 E-course-yaml each of `macros` must be a plain value\n");
  EXPECT_EQ(mistakes_in("title: C\nlevels: 1-a\n"),
            "2:9 E-course-yaml `levels` must be a list with at least one item\n");
  EXPECT_EQ(mistakes_in("title: C\nlevels: [1-a]\n"),
            "2:10 E-course-yaml the level must be a mapping: `key: value` lines\n");
  EXPECT_EQ(mistakes_in("title: C\nlevels: [{folder: 1-a, title: L, lessons: 1.1-x}]\n"),
            "2:43 E-course-yaml `lessons` must be a list: [a, b]\n");
  EXPECT_EQ(
      mistakes_in("title: [\n"),
      "2:1 E-course-yaml the course file is not YAML: end of sequence flow not found | quote a "
      "value that holds `: ` or starts with a special character\n");
}

TEST(Course, SuggestsTheLessonThatWasMeant) {
  const CourseOf found({{"content/course.yaml", kTwo},
                        {"content/1-a/1.1-x.md", lesson("")},
                        {"content/1-a/1.2-z.md", lesson("")},
                        {"content/1-a/notes.txt", ""}});
  EXPECT_EQ(found.course->lessons.size(), 1u);
  EXPECT_EQ(
      found.mistakes(),
      R"(content/course.yaml:5:22: error: there is no file content/1-a/1.2-y.md [E-lesson-missing]
  5 |     lessons: [1.1-x, 1.2-y]
    |                      ^~~~~
  cure: did you mean `1.2-z`?
)");
}

TEST(Course, WarnsOfALessonThatNobodyChecks) {
  const CourseOf found({{"content/course.yaml", kTwo},
                        {"content/1-a/1.1-x.md", lesson("")},
                        {"content/1-a/1.2-y.md", lesson("")},
                        {"content/1-a/1.3-z.md", lesson("")},
                        {"content/1-a/notes.txt", ""}});
  EXPECT_EQ(
      found.mistakes(),
      R"(content/1-a/1.3-z.md: warning: course.yaml does not list this lesson, so it is not checked [W-lesson-unlisted]
  cure: add it to the `lessons` of its level; `draft: true` keeps it out of the site
)");
}

TEST(Course, TakesEachNumberOnce) {
  const CourseOf found({{"content/course.yaml",
                         "title: C\nlevels:\n  - folder: 1-a\n    title: L\n"
                         "    lessons: [1.1-x, 1.1-other]\n"},
                        {"content/1-a/1.1-x.md", lesson("")},
                        {"content/1-a/1.1-other.md", lesson("")}});
  EXPECT_EQ(
      found.mistakes(),
      R"(content/course.yaml:5:22: error: the number 1.1 is taken by a lesson above [E-lesson-number]
  5 |     lessons: [1.1-x, 1.1-other]
    |                      ^~~~~~~~~
  cure: number each lesson once
)");
}

TEST(Course, ReadsOnAfterALessonThatCannotBeRead) {
  const CourseOf found({{"content/course.yaml", kTwo},
                        {"content/1-a/1.1-x.md", "no front matter"},
                        {"content/1-a/1.2-y.md", lesson("> [!nte] x\n")}});
  ASSERT_EQ(found.diagnostics.size(), 2u);
  EXPECT_EQ(found.diagnostics[0].id, "E-front-matter");
  EXPECT_EQ(found.diagnostics[1].place.file, "content/1-a/1.2-y.md");
  EXPECT_EQ(found.course->lessons.size(), 1u);
}

// Where a course's names would have its pages lie elsewhere, or nowhere.
TEST(ReadCourse, TakesPlainNamesOfLevelsAndLessons) {
  const CourseOf read({{"content/course.yaml", R"(title: C
levels:
  - {folder: "..", title: Above, lessons: [1.1-x]}
  - {folder: 1-a, title: First, lessons: ["../1-a/1.1-x", 1.2-y, "1.3-\u0007"]}
  - {folder: Models, title: Models}
  - {folder: Sw.JS, title: Worker}
)"},
                       {"content/../1.1-x.md", lesson("")},
                       {"content/1-a/../1-a/1.1-x.md", lesson("")},
                       {"content/1-a/1.2-y.md", lesson("")}});
  EXPECT_EQ(
      read.mistakes(),
      R"(content/course.yaml:3:15: error: a level lies in a folder of `content/`, and `..` is the folder above [E-level-folder]
  3 |   - {folder: "..", title: Above, lessons: [1.1-x]}
    |               ^~
  cure: give the folder one plain name, as `1-first-steps`, and write that here
content/course.yaml:4:44: error: a lesson is a file in its level's folder, and `../1-a/1.1-x` has a `/` in it, where the name of a folder ends [E-lesson-name]
  4 |   - {folder: 1-a, title: First, lessons: ["../1-a/1.1-x", 1.2-y, "1.3-\u0007"]}
    |                                            ^~~~~~~~~~~~
  cure: give the file one plain name, as `1.2-a-title.md`, and write that here without `.md`
content/course.yaml:4:66: error: a lesson is a file in its level's folder, and `1.3-\x07` has a control character in it [E-lesson-name]
  4 |   - {folder: 1-a, title: First, lessons: ["../1-a/1.1-x", 1.2-y, "1.3-\u0007"]}
    |                                                                  ^
  cure: give the file one plain name, as `1.2-a-title.md`, and write that here without `.md`
content/course.yaml:5:14: error: a level lies in a folder of `content/`, and `Models` is where the site has the pages of models [E-level-folder]
  5 |   - {folder: Models, title: Models}
    |              ^~~~~~
  cure: give the folder one plain name, as `1-first-steps`, and write that here
content/course.yaml:6:14: error: a level lies in a folder of `content/`, and `Sw.JS` ends as a file of the site does [E-level-folder]
  6 |   - {folder: Sw.JS, title: Worker}
    |              ^~~~~
  cure: give the folder one plain name, as `1-first-steps`, and write that here
)");
  ASSERT_EQ(read.course->lessons.size(), 1u);
  EXPECT_EQ(read.course->lessons[0].number, "1.2");
  ASSERT_EQ(read.course->levels.size(), 1u);
}

TEST(ReadCourse, HasPlainNamesForWhatReadersGet) {
  const CourseOf read({{"content/course.yaml", kTwo},
                       {"content/1-a/1.1-x.md", lesson("")},
                       {"content/1-a/1.2-y.md", lesson("")},
                       {"models/a b.xml", ""},
                       {"models/a\nCNAME\nb.xml", ""},
                       {"models/arm/nul.stl", ""},
                       {"models/.arm.xml.swp", ""},
                       {"models/.old/arm.xml", ""},
                       {"models/m.html/part.xml", ""},
                       {"examples/include/..\\..\\a.hpp", ""},
                       {"examples/.deep/a:b.hpp", ""},
                       {"examples/b.cpp", ""}});
  const std::string cure =
      "  cure: rename it; letters, digits, `-`, `_` and dots are good everywhere\n";
  EXPECT_EQ(read.mistakes(),
            "models/a\\nCNAME\\nb.xml: error: readers get the files of `models/`, and "
            "`a\\nCNAME\\nb.xml` has a control character in it [E-file-name]\n" +
                cure +
                "models/arm/nul.stl: error: readers get the files of `models/`, and `nul.stl` is a "
                "device on Windows [E-file-name]\n" +
                cure +
                "models/m.html/part.xml: error: readers get the files of `models/`, and `m.html` "
                "ends as a file of the site does [E-file-name]\n" +
                cure +
                "examples/.deep/a:b.hpp: error: readers get the files of `examples/`, and "
                "`a:b.hpp` has a `:` in it, which no name on Windows has [E-file-name]\n" +
                cure +
                "examples/include/..\\..\\a.hpp: error: readers get the files of `examples/`, and "
                "`..\\..\\a.hpp` has a `\\` in it, which is a `/` on Windows [E-file-name]\n" +
                cure);
  EXPECT_EQ(read.course->models, (std::vector<std::string>{".old/arm", "a b", "m.html/part"}));
}

TEST(ReadCourse, UnloadsLessons) {
  const CourseOf read = course_of("$x$\n", "## Here\n\n[one](1.1)\n");
  EXPECT_EQ(read.mistakes(), "");
  EXPECT_EQ(read.course->find_lesson("1.1")->kept, Lesson::Kept::blocks);
  const Lesson& prose = *read.course->find_lesson("1.2");
  EXPECT_EQ(prose.kept, Lesson::Kept::outline);
  EXPECT_EQ(prose.headings.at(0).id, "here");
  EXPECT_TRUE(prose.links.empty());
}

TEST(ReadCourse, KeepsTheFirstLessonsLoaded) {
  const MemoryFiles files({{"content/course.yaml", kTwo},
                           {"content/1-a/1.1-x.md", lesson("One.\n")},
                           {"content/1-a/1.2-y.md", lesson("Two.\n")}});
  Diagnostics diagnostics;
  const std::optional<Course> course = read_course(files, diagnostics, 2, 1);
  EXPECT_EQ(course->lessons.at(0).kept, Lesson::Kept::all);
  EXPECT_EQ(course->lessons.at(1).kept, Lesson::Kept::outline);
}

// What needs its text to be told keeps it.
TEST(ReadCourse, KeepsTheTextOfProseWithMistakes) {
  const CourseOf dead = course_of("", "[one](1.9)\n");
  EXPECT_NE(dead.mistakes(), "");
  EXPECT_EQ(dead.course->find_lesson("1.2")->kept, Lesson::Kept::blocks);
  const CourseOf unclosed = course_of("", "text $$\n");
  EXPECT_NE(unclosed.mistakes(), "");
  EXPECT_EQ(unclosed.course->find_lesson("1.2")->kept, Lesson::Kept::blocks);
}

TEST(ReadCourse, IsTheSameOnAnyNumberOfThreads) {
  std::map<std::string, std::string> files;
  std::string names;
  for (int i = 1; i <= 40; ++i) {
    const std::string name = "1." + std::to_string(i) + "-x";
    files["content/1-a/" + name + ".md"] =
        lesson("~~a~~ $x$ $$ [b](1." + std::to_string(i + 1) + "#no)\n");
    names += (i == 1 ? "" : ", ") + name;
  }
  files["content/course.yaml"] =
      "title: C\nlevels:\n  - {folder: 1-a, title: A, lessons: [" + names + "]}\n";
  const auto mistakes = [&](std::size_t threads) {
    Diagnostics diagnostics;
    read_course(MemoryFiles(files), diagnostics, threads);
    return shown(diagnostics);
  };
  const std::string alone = mistakes(1);
  EXPECT_EQ(std::count(alone.begin(), alone.end(), '^'), 80);
  for (int trial = 0; trial < 10; ++trial) EXPECT_EQ(mistakes(4), alone);
}

}  // namespace
}  // namespace mjcourse
