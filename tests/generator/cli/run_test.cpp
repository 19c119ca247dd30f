#include "cli/run.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

struct Ran {
  int code;
  std::string out, err;
};

Ran ran(const std::vector<std::string>& arguments) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int code = run_command(arguments);
  return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

// What a wrong command line is answered with.
std::string usage_error(const std::vector<std::string>& arguments) {
  const Ran result = ran(arguments);
  EXPECT_EQ(result.code, kWrongUsage);
  EXPECT_EQ(result.out, "");
  const std::string end = "\n`mjcourse --help` shows the commands\n";
  EXPECT_TRUE(result.err.ends_with(end)) << result.err;
  return result.err.substr(0, result.err.size() - end.size());
}

TEST(Run, HelpsOnStdout) {
  for (const char* word : {"--help", "help"}) {
    const Ran result = ran({word});
    EXPECT_EQ(result.code, kClean);
    EXPECT_TRUE(result.out.starts_with("usage: mjcourse COMMAND [OPTIONS]\n")) << result.out;
    EXPECT_EQ(result.err, "");
  }
}

TEST(Run, TellsItsVersion) {
  const Ran result = ran({"--version"});
  EXPECT_EQ(result.code, kClean);
  EXPECT_TRUE(result.out.starts_with("mjcourse 0.")) << result.out;
}

TEST(Run, NeedsACommandThatThereIs) {
  EXPECT_EQ(usage_error({}), "mjcourse: which command?");
  EXPECT_EQ(usage_error({"biuld"}), "mjcourse: there is no command biuld; did you mean `build`?");
  EXPECT_EQ(usage_error({"frobnicate"}),
            "mjcourse: there is no command frobnicate; known: accept, build, check");
}

TEST(Run, NeedsOptionsThatThereAre) {
  EXPECT_EQ(usage_error({"check", "--corse", "x"}),
            "mjcourse: check has no option --corse; did you mean `--course`?");
  EXPECT_EQ(usage_error({"check", "--out", "x"}),
            "mjcourse: check has no option --out; known: --course, --report, --strict");
  EXPECT_EQ(usage_error({"build", "--outt", "x"}),
            "mjcourse: build has no option --outt; did you mean `--out`?");
  EXPECT_EQ(usage_error({"check", "1.2"}),
            "mjcourse: check has no option 1.2; known: --course, --report, --strict");
  EXPECT_EQ(usage_error({"accept", "1.2", "--dry-runn"}),
            "mjcourse: accept has no option --dry-runn; did you mean `--dry-run`?");
  EXPECT_EQ(usage_error({"build", "--strict"}),
            "mjcourse: build has no option --strict; known: --course, --out, --report");
  EXPECT_EQ(usage_error({"check", "--course"}), "mjcourse: --course needs a folder");
  EXPECT_EQ(usage_error({"build", "--course", "x", "--out"}), "mjcourse: --out needs a folder");
}

class RunOnACourse : public testing::Test {
 protected:
  RunOnACourse() {
    setenv("MJCOURSE_ASSETS", MJCOURSE_ASSETS, 1);
    write("content/course.yaml", "title: C\nlevels: [{folder: 1-a, title: A, lessons: [1.1-x]}]\n");
    write("content/1-a/1.1-x.md", "---\ntitle: First\n---\nText.\n");
  }
  ~RunOnACourse() override { unsetenv("MJCOURSE_ASSETS"); }

  void write(const std::string& path, const std::string& bytes) const {
    write_file(folder_.path() / path, bytes);
  }
  // Without the time it took, which is never the same.
  Ran on_course(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--course", folder_.path().string()});
    Ran result = ran(arguments);
    if (const std::size_t comma = result.out.find(" errors, "); comma != std::string::npos) {
      result.out.erase(comma + 7, result.out.find('\n', comma) - comma - 7);
    }
    return result;
  }

  TemporaryFolder folder_;
};

TEST_F(RunOnACourse, ChecksAndWritesNothing) {
  const Ran result = on_course({"check"});
  EXPECT_EQ(result.code, kClean);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out,
            "ok    1.1  First: nothing to verify\n1 lesson: nothing to verify; 0 errors\n");
  EXPECT_FALSE(fs::exists(folder_.path() / "build"));
}

TEST_F(RunOnACourse, BuildsTheSite) {
  const fs::path site = folder_.path() / "elsewhere";
  const Ran result = on_course({"build", "--out", site.string()});
  EXPECT_EQ(result.code, kClean);
  EXPECT_TRUE(result.out.ends_with("site: " + site.string() + "/index.html\n")) << result.out;
  EXPECT_TRUE(fs::exists(site / "index.html"));
  EXPECT_TRUE(fs::exists(site / "1-a" / "1.1-x.html"));
}

TEST_F(RunOnACourse, BuildsNoSiteOfACourseWithErrors) {
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\n> [!nte] x\n\n[dead](1.2)\n");
  const Ran result = on_course({"build"});
  EXPECT_EQ(result.code, kCourseErrors);
  EXPECT_EQ(result.err,
            R"(content/1-a/1.1-x.md:4:5: error: there is no callout `nte` [E-callout-kind]
  4 | > [!nte] x
    |     ^~~
  cure: did you mean `note`?

content/1-a/1.1-x.md:6:8: error: there is no lesson `1.2` in this course [E-link-dead]
  6 | [dead](1.2)
    |        ^~~
  cure: add it to content/course.yaml

)");
  EXPECT_EQ(result.out,
            "FAIL  1.1  First: nothing verified; 2 errors\n"
            "1 lesson: nothing verified; 2 errors\n"
            "no site was written: mend the errors first\n");
  EXPECT_FALSE(fs::exists(folder_.path() / "build"));
}

TEST_F(RunOnACourse, ChecksStrictlyWhenAsked) {
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\n```sh unchecked\nls\n```\n");
  EXPECT_EQ(on_course({"check"}).code, kClean);
  const Ran strict = on_course({"check", "--strict"});
  EXPECT_EQ(strict.code, kCourseErrors);
  EXPECT_TRUE(strict.err.starts_with(
      "content/1-a/1.1-x.md:4:1: error: nobody runs this code, and nothing says why"))
      << strict.err;
}

TEST_F(RunOnACourse, ReportsAlsoWhatFailed) {
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\n$\\alhpa$\n");
  const fs::path report = folder_.path() / "report";
  const Ran result = on_course({"check", "--report", report.string()});
  EXPECT_EQ(result.code, kCourseErrors);
  EXPECT_TRUE(result.out.ends_with("report: " + report.string() + "/index.html\n")) << result.out;
  const std::string page = DiskFiles(report).read("index.html").value();
  EXPECT_NE(page.find("\\alpha"), std::string::npos);
  EXPECT_TRUE(fs::exists(report / "verification.json"));
}

TEST_F(RunOnACourse, FailsALessonWhoseModelIsWrong) {
  write("models/bad.xml", "<mujoco>\n  <geom/>\n</mujoco>\n");
  write("content/1-a/1.1-x.md",
        "---\ntitle: First\n---\n```lab simlab\n{\"title\": \"T\", \"model\": \"bad\"}\n```\n");
  const Ran result = on_course({"check"});
  EXPECT_EQ(result.code, kCourseErrors);
  EXPECT_TRUE(result.out.starts_with("FAIL  1.1")) << result.out;
}

TEST_F(RunOnACourse, SaysThatThereIsNoCourse) {
  fs::remove(folder_.path() / "content" / "course.yaml");
  const Ran result = on_course({"check"});
  EXPECT_EQ(result.code, kCourseErrors);
  EXPECT_TRUE(result.err.starts_with("content/course.yaml: error: cannot read ")) << result.err;
}

TEST_F(RunOnACourse, BlamesItselfForWhatNoAuthorCanMend) {
  setenv("MJCOURSE_ASSETS", "/nowhere", 1);
  const Ran result = on_course({"check"});
  EXPECT_EQ(result.code, kOurFault);
  EXPECT_EQ(
      result.err,
      "mjcourse: the site's assets are not built: script/world.js: No such file or directory\n");
}

TEST_F(RunOnACourse, BlamesItselfForASiteItMayNotReplace) {
  write("mine/precious.txt", "work of years");
  const fs::path site = folder_.path() / "mine";
  const Ran result = on_course({"build", "--out", site.string()});
  EXPECT_EQ(result.code, kOurFault);
  EXPECT_EQ(result.err, "mjcourse: " + site.string() +
                            " holds something that no build made; it would be replaced. Name an "
                            "empty or a new folder.\n");
}

}  // namespace
}  // namespace mjcourse
