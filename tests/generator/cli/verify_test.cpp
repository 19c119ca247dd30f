#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "cli/on_a_course.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

class Verify : public OnACourse {};

TEST_F(Verify, ChecksAndWritesNothing) {
  const Ran result = on_course({"check"});
  EXPECT_EQ(result.code, kClean);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out,
            "ok    1.1  First: nothing to verify\n1 lesson: nothing to verify; 0 errors\n");
  EXPECT_FALSE(fs::exists(folder_.path() / "build"));
}

TEST_F(Verify, TellsAnotherToolOnStdoutAndAPersonOnStderr) {
  const std::string human = "ok    1.1  First: nothing to verify\n1 lesson: nothing to verify; ";
  for (const std::string format : {"json", "sarif", "junit"}) {
    const Ran result = on_course({"check", "--format=" + format});
    EXPECT_EQ(result.code, kClean);
    EXPECT_TRUE(result.err.starts_with(human)) << result.err;
    EXPECT_TRUE(result.out.starts_with(format == "junit" ? "<?xml" : "{")) << result.out;
  }
  EXPECT_EQ(on_course({"check", "--format", "github"}).out, "");
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\n[dead](1.2)\n");
  const Ran result = on_course({"check", "--format", "github"});
  EXPECT_EQ(result.code, kCourseErrors);
  const std::string file =
      (folder_.path() / "content/1-a/1.1-x.md").lexically_relative(fs::current_path()).string();
  EXPECT_EQ(result.out,
            "::error file=" + file +
                ",line=4,col=8,endColumn=11,title=E-link-dead::there is no lesson `1.2` in "
                "this course%0Acure: add it to content/course.yaml\n");
}

TEST_F(Verify, ChecksStrictlyWhenAsked) {
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\n```sh unchecked\nls\n```\n");
  EXPECT_EQ(on_course({"check"}).code, kClean);
  const Ran strict = on_course({"check", "--strict"});
  EXPECT_EQ(strict.code, kCourseErrors);
  EXPECT_TRUE(strict.err.starts_with(
      "content/1-a/1.1-x.md:4:1: error: nobody runs this code, and nothing says why"))
      << strict.err;
}

TEST_F(Verify, ReportsAlsoWhatFailed) {
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\n$\\alhpa$\n");
  const fs::path report = folder_.path() / "report";
  const Ran result = on_course({"check", "--report", report.string()});
  EXPECT_EQ(result.code, kCourseErrors);
  EXPECT_TRUE(result.out.ends_with("report: " + report.string() + "/index.html\n")) << result.out;
  const std::string page = DiskFiles(report).read("index.html").value();
  EXPECT_NE(page.find("\\alpha"), std::string::npos);
  EXPECT_TRUE(fs::exists(report / "verification.json"));
}

TEST_F(Verify, FailsALessonWhoseModelIsWrong) {
  write("models/bad.xml", "<mujoco>\n  <geom/>\n</mujoco>\n");
  write("content/1-a/1.1-x.md",
        "---\ntitle: First\n---\n```lab simlab\n{\"title\": \"T\", \"model\": \"bad\", \"alt\": "
        "\"A\"}\n```\n");
  const Ran result = on_course({"check"});
  EXPECT_EQ(result.code, kCourseErrors);
  EXPECT_TRUE(result.out.starts_with("FAIL  1.1")) << result.out;
}

TEST_F(Verify, SaysThatThereIsNoCourse) {
  fs::remove(folder_.path() / "content" / "course.yaml");
  const Ran result = on_course({"check"});
  EXPECT_EQ(result.code, kCourseErrors);
  EXPECT_TRUE(result.err.starts_with("content/course.yaml: error: cannot read ")) << result.err;
}

TEST_F(Verify, BlamesItselfForWhatNoAuthorCanMend) {
  setenv("MJCOURSE_ASSETS", "/nowhere", 1);
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\n$x$\n");
  const Ran result = on_course({"check"});
  EXPECT_EQ(result.code, kOurFault);
  EXPECT_EQ(
      result.err,
      "mjcourse: the site's assets are not built: script/typeset.js: No such file or directory\n");
}

}  // namespace
}  // namespace mjcourse
