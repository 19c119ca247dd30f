// What a worker says that a site may have of a model.
#include "evaluate/result_fits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/temporary_folder.h"
#include "course/course.h"
#include "evaluate/plan.h"

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
  // As a lab brings the picture along under the name `name`.
  bool brings(const std::string& name) const {
    LabResult result;
    result.model.assets[name] = folder_.path() / "models/picture.png";
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
  EXPECT_FALSE(lists("models/missing.xml"));
  EXPECT_FALSE(lists("content/1-a/1.1-x.md"));
}

TEST_F(FilesOfAModel, GoWithALabUnderSuchNames) {
  EXPECT_TRUE(brings("picture.png"));
  EXPECT_FALSE(brings("picture.html"));
  EXPECT_FALSE(brings("picture.svg"));
}

}  // namespace
}  // namespace mjcourse
