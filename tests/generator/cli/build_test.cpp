#include <gtest/gtest.h>

#include <filesystem>

#include "cli/on_a_course.h"
#include "course/course.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

class Build : public OnACourse {};

TEST_F(Build, BuildsTheSite) {
  const fs::path site = folder_.path() / "elsewhere";
  const Ran result = on_course({"build", "--out", site.string()});
  EXPECT_EQ(result.code, kClean);
  EXPECT_TRUE(result.out.ends_with("site: " + site.string() + "/index.html\n")) << result.out;
  EXPECT_TRUE(fs::exists(site / "index.html"));
  EXPECT_TRUE(fs::exists(site / "1-a" / "1.1-x.html"));
}

TEST_F(Build, WritesIntoTheFolderThatItIsRunIn) {
  const fs::path before = fs::current_path();
  const TemporaryFolder here;
  fs::current_path(here.path());
  const Ran result =
      on_course({"build", "--out", "site", "--report", "report", "--trace", "trace.json"});
  fs::current_path(before);
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(result.out.ends_with("report: report/index.html\nsite: site/index.html\n"))
      << result.out;
  for (const char* file : {"site/index.html", "report/index.html", "trace.json"}) {
    EXPECT_TRUE(fs::exists(here.path() / file)) << file;
  }
}

TEST_F(Build, BuildsMoreLessonsThanStayLoaded) {
  const int last = static_cast<int>(kMostLoaded) + 1;
  std::string names;
  for (int i = 1; i <= last; ++i) {
    const std::string number = "1." + std::to_string(i);
    names += number + "-x, ";
    write("content/1-a/" + number + "-x.md",
          "---\ntitle: T\n---\nThe text of " + number + ".\n\n```sh unchecked\nx\n```\n");
  }
  write("content/course.yaml",
        "title: C\nlevels: [{folder: 1-a, title: A, lessons: [" + names + "]}]\n");
  EXPECT_EQ(on_course({"build"}).code, kClean);
  const DiskFiles site(folder_.path() / "build/site");
  for (const std::string& number : {std::string("1.1"), "1." + std::to_string(last)}) {
    const std::string page = site.read("1-a/" + number + "-x.html").value();
    EXPECT_NE(page.find("The text of " + number + "."), std::string::npos) << number;
    EXPECT_NE(page.find("<figure class=\"example\">"), std::string::npos) << number;
  }
}

TEST_F(Build, BuildsNoSiteOfACourseWithErrors) {
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
            "no site was written: fix the errors first\n");
  EXPECT_FALSE(fs::exists(folder_.path() / "build"));
}

TEST_F(Build, ReplacesNothingThatItDidNotMake) {
  write("mine/precious.txt", "work of years");
  const fs::path mine = folder_.path() / "mine";
  const std::string said = "mjcourse: " + mine.string() +
                           " holds something that no build made, and would be replaced\n"
                           "  cure: name an empty or a new folder\n";
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"build", "--out"}, {"check", "--report"}}) {
    const Ran result = on_course({words[0], words[1], mine.string()});
    EXPECT_EQ(result.code, kWrongUsage) << words[0];
    EXPECT_EQ(result.err, said) << words[0];
  }
  EXPECT_EQ(read_file(mine / "precious.txt").value(), "work of years");
}

}  // namespace
}  // namespace mjcourse
