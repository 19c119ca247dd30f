#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/on_a_course.h"

namespace mjcourse {
namespace {

class List : public OnACourse {};

TEST_F(List, ListsHowLessonsStand) {
  write("content/course.yaml",
        "title: C\nlevels: [{folder: 1-a, title: A, lessons: [1.1-x, 1.2-y, 1.3-z]}]\n");
  write("content/1-a/1.3-z.md", "---\ntitle: 物理\ndraft: true\n---\nText.\n");
  write("content/1-a/1.1-x.md",
        "---\ntitle: Äpfel\nminutes: 7\n---\nTwo *words*, and $x$.\n\n"
        "```sh unchecked because=\"b\"\nx\n```\n");
  write("content/1-a/1.2-y.md", "---\ntitle: Second\ndraft: true\n---\nText.\n\n[dead](1.9)\n");
  const Ran result = on_course({"list"});
  EXPECT_EQ(result.code, kCourseErrors);
  EXPECT_EQ(result.out,
            "     lesson          words  minutes  proved  asserted  open  changed\n"
            "1.1  Äpfel               4        7       1               1\n"
            "1.2  Second (draft)      2\n"
            "1.3  物理 (draft)        1\n"
            "1 error; `mjcourse check` shows them\n");
}

TEST_F(List, ListsWhenLessonsWereChanged) {
  const auto git = [&](const std::string& arguments) {
    const std::string command =
        "git -C " + folder_.path().string() + " -c user.name=A -c user.email=a@b " + arguments;
    EXPECT_EQ(std::system((command + " >/dev/null 2>&1").c_str()), 0) << command;
  };
  write("content/course.yaml",
        "title: C\nlevels: [{folder: 1-a, title: A, lessons: [1.1-x, 1.2-y]}]\n");
  git("init");
  git("add content/1-a");
  setenv("GIT_COMMITTER_DATE", "2021-03-04T12:00:00Z", 1);
  git("commit -m x");
  unsetenv("GIT_COMMITTER_DATE");
  write("content/1-a/1.2-y.md", "---\ntitle: Second\n---\nText.\n");
  EXPECT_EQ(on_course({"list"}).out,
            "     lesson  words  minutes  proved  asserted  open  changed\n"
            "1.1  First       1                                   2021-03-04\n"
            "1.2  Second      1                                   not committed\n");
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\nMore text.\n");
  EXPECT_NE(on_course({"list"}).out.find("1.1  First       2                                   "
                                         "not committed\n"),
            std::string::npos);
}

}  // namespace
}  // namespace mjcourse
