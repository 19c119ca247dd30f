// What a worker says that a site may have of a model.
#include "evaluate/result_fits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/temporary_folder.h"
#include "course/course.h"
#include "evaluate/plan.h"
#include "lesson/lesson_of_lab.h"
#include "reading_of.h"

namespace mjcourse {
namespace {

constexpr const char* kShowsBall =
    "---\ntitle: T\n---\nOf [it](model:ball).\n\n"
    "```lab simlab\n{\"title\": \"L\", \"model\": \"ball\", \"alt\": \"A ball.\"}\n```\n";

class FilesOfAModel : public testing::Test {
 protected:
  FilesOfAModel() {
    write("content/course.yaml", "title: C\nlevels: [{folder: 1-a, title: A, lessons: [1.1-x]}]\n");
    write("content/1-a/1.1-x.md", kShowsBall);
    write("models/ball.xml", "<mujoco/>");
    write("models/page.html", "<script>alert(1)</script>");
    write("models/styled.xml", "<?xml-stylesheet href='x.xsl'?>\n<mujoco/>");
    write("models/picture.png", "");
    write("models/drawn.xml", "<mujoco><svg xmlns='http://www.w3.org/2000/svg'/></mujoco>");
    write("models/page", "<script>alert(1)</script>");
    Diagnostics mistakes;
    course_ = *read_course(DiskFiles(folder_.path()), mistakes, 1, 0);
    tasks_ = plan_tasks(course_);
  }
  void write(const std::string& path, const std::string& text) const {
    write_file(folder_.path() / path, text);
  }

  // As a page of the model lists `file`.
  bool lists(const std::string& file) const {
    Finding finding;
    finding.model_page.emplace();
    finding.model_page->name = "ball";
    finding.model_page->files = {{file, ""}};
    return std::ranges::any_of(tasks_, [&](const auto& task) {
      return task->model() == "ball" && fits(*task, finding, folder_.path());
    });
  }
  // As a page of the model has the lab of `fence`, which was made for the page of `model`.
  bool plays(const std::string& model, const std::string& fence) const {
    Finding finding;
    finding.model_page.emplace();
    finding.model_page->name = "ball";
    finding.model_page->lab = {lesson_of_lab(model, fence), {}};
    return std::ranges::any_of(tasks_, [&](const auto& task) {
      return task->model() == "ball" && fits(*task, finding, folder_.path());
    });
  }
  // As a lab brings a file of the models along under the name `name`.
  bool brings(const std::string& name, const std::string& file = "picture.png") const {
    LabResult result;
    result.model.assets[name] = folder_.path() / "models" / file;
    return std::ranges::any_of(tasks_, [&](const auto& task) {
      if (task->blocks().empty()) return false;
      Finding finding;
      finding.results[task->block()] = result;
      return fits(*task, finding, folder_.path());
    });
  }

  TemporaryFolder folder_;
  Course course_;
  Tasks tasks_;
};

TEST_F(FilesOfAModel, AreWhatNoBrowserRuns) {
  EXPECT_TRUE(lists("models/ball.xml"));
  EXPECT_TRUE(lists("models/picture.png"));
  EXPECT_FALSE(lists("models/page.html"));
  EXPECT_FALSE(lists("models/styled.xml"));
  EXPECT_FALSE(lists("models/drawn.xml"));
  EXPECT_FALSE(lists("models/page"));
  EXPECT_FALSE(lists("models/missing.xml"));
  EXPECT_FALSE(lists("content/1-a/1.1-x.md"));
}

TEST_F(FilesOfAModel, GoWithALabUnderSuchNames) {
  EXPECT_TRUE(brings("picture.png"));
  EXPECT_FALSE(brings("picture.html"));
  EXPECT_FALSE(brings("picture.svg"));
  EXPECT_FALSE(brings("page", "page"));
}

TEST_F(FilesOfAModel, ArePlayedInOneLabOfTheModelsPage) {
  const std::string lab =
      "```lab simlab\n{\"title\": \"L\", \"model\": \"ball\", \"alt\": \"A ball.\"}\n```\n";
  EXPECT_TRUE(plays("ball", lab));
  EXPECT_FALSE(plays("../../ball", lab));
  EXPECT_FALSE(plays("ball", lab + lab));
  EXPECT_FALSE(plays("ball", "Text.\n"));
  EXPECT_FALSE(plays("ball", "> [!note] A callout\n"));
}

// A lab of one readout, with one button.
const ReadingOf& lab() {
  static const ReadingOf reading = reading_of(
      "```lab simlab\n{\"title\": \"T\", \"model\": \"m\", \"alt\": \"A.\", \"controls\": "
      "[{\"type\": "
      "\"button\", \"label\": \"B\", \"run\": \"step(1)\"}], \"readouts\": [{\"label\": \"r\", "
      "\"expr\": \"1\"}]}\n```\n");
  return reading;
}

// Whether a result with one run, on which `control` acted and which read `values`, is that lab's.
bool fits_the_lab(std::optional<std::size_t> control, const std::vector<double>& values) {
  LabResult result;
  result.readouts = {1};
  result.keyframes = {0};
  result.runs = {{control, ControlValue(), {{0, values, {}}}}};
  return fits(lab().lesson->blocks.at(0), Result(result)) &&
         fits(lab().lesson->blocks.at(0), result);
}

TEST(ResultFits, WhereEachRunHasThePartsOfItsLab) {
  EXPECT_TRUE(fits_the_lab(std::nullopt, {1}));
  EXPECT_TRUE(fits_the_lab(0, {1}));
  EXPECT_FALSE(fits_the_lab(1, {1}));
  EXPECT_FALSE(fits_the_lab(0, {}));
}

TEST(ResultFits, WhereEachReadingHasTheTracesOfTheGhost) {
  const ReadingOf reading = reading_of(
      "```lab simlab\n{\"title\": \"T\", \"model\": \"m\", \"alt\": \"A.\", \"plots\": "
      "[{\"ylabel\": "
      "\"y\", \"traces\": [{\"label\": \"t\", \"expr\": \"1\"}]}], \"ghost\": {\"label\": \"G\", "
      "\"run\": \"step(1)\"}}\n```\n");
  LabResult result;
  result.traces = {{1}};
  result.runs = {{std::nullopt, {}, {{0, {}, {1}}}}};
  EXPECT_TRUE(fits(reading.lesson->blocks.at(0), Result(result)));
  result.runs[0].readings[0].ghost.clear();
  EXPECT_FALSE(fits(reading.lesson->blocks.at(0), Result(result)));
}

TEST(ResultFits, WhereColumnsAreEquallyLong) {
  const ReadingOf program = reading_of("```cpp file=examples/a.cpp\n```\n");
  ExampleResult result;
  result.records.tables["t"] = {{"a", {1}}, {"b", {2}}};
  EXPECT_TRUE(fits(program.lesson->blocks.at(0), Result(result)));
  result.records.tables["t"][1].values.clear();
  EXPECT_FALSE(fits(program.lesson->blocks.at(0), Result(result)));
}

TEST(ResultFits, WhereAProgramsFilesStayInItsArchive) {
  const ReadingOf reading = reading_of(
      "```cpp file=examples/a.cpp\n```\n```cpp snippet model=m\nx;\n```\n"
      "```cpp exercise file=examples/a.cpp#b\n```\n```sh run files=.x\nls\n```\n");
  const auto fits_as = [&](std::size_t block, const std::string& file) {
    ExampleResult result;
    result.files = {"examples/include/a.hpp", file};
    return fits(reading.lesson->blocks.at(block), Result(result));
  };
  for (std::size_t block = 0; block < 3; ++block) {
    EXPECT_TRUE(fits_as(block, "models/.hidden/b.xml")) << block;
    for (const char* file : {"../a", "examples/../../.ssh/x", "/etc/passwd", "a\\b", "x/.GIT/y"}) {
      EXPECT_FALSE(fits_as(block, file)) << block << file;
    }
  }
  EXPECT_TRUE(fits_as(3, "a\\b"));  // of which there is no archive
  ExerciseResult exercise;
  exercise.files = {"../a"};
  EXPECT_FALSE(fits(reading.lesson->blocks.at(2), Result(exercise)));
}

// Of its copy's name in the site.
TEST(ResultFits, WhereAPicturesHashIsNoPath) {
  const ReadingOf reading = reading_of("![A picture](p.png)\n");
  const auto fits_as = [&](const std::string& hash) {
    return fits(reading.lesson->blocks.at(0), Result(ImageResult{"p.png", hash, 1, 1}));
  };
  EXPECT_TRUE(fits_as("x4std3708x"));
  for (const char* hash : {"", "/../../x", "a.b", "a/b", "a\nb"})
    EXPECT_FALSE(fits_as(hash)) << hash;
}

}  // namespace
}  // namespace mjcourse
