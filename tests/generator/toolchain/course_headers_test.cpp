#include "toolchain/course_headers.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

TEST(CourseHeaders, HaveOneNameWhereverTheCourseLies) {
  const CourseHeaders headers({"/course/examples/include", "/tool/include"});
  EXPECT_EQ(headers.shown(), (IncludeFolders{"/mjcourse/include-0", "/mjcourse/include-1"}));
  EXPECT_EQ(headers.true_path("/mjcourse/include-1/a/b.h"), "/tool/include/a/b.h");
  EXPECT_EQ(headers.true_path("/mjcourse/include-10/b.h"), "/mjcourse/include-10/b.h");
  EXPECT_EQ(headers.true_path("/usr/include/stdio.h"), "/usr/include/stdio.h");
}

TEST(CourseHeaders, AreShownToACompiler) {
  const CourseHeaders headers({"/course/\"quoted\"/include"});
  EXPECT_EQ(headers.overlay("/kept/header.hpp"),
            R"({"roots":[{"external-contents":"/course/\"quoted\"/include",)"
            R"("name":"/mjcourse/include-0","type":"directory-remap"},)"
            R"({"external-contents":"/kept/header.hpp","name":"/mjcourse/header.hpp",)"
            R"("type":"file"}],"use-external-names":false,"version":0})");
}

TEST(CourseHeaders, AreKnownByNamesAndContents) {
  const TemporaryFolder folder;
  const auto contents = [&](const char* course) {
    return CourseHeaders({folder.path() / course, folder.path() / "none"}).contents();
  };
  for (const char* course : {"a", "b"}) {
    write_file(folder.path() / course / "kit/one.h", "1");
    write_file(folder.path() / course / "two.h", "2");
  }
  EXPECT_EQ(contents("a"), contents("b"));
  EXPECT_NE(contents("a"), "");
  EXPECT_EQ(contents("none"), "");
  write_file(folder.path() / "b/two.h", "3");
  const std::string other = contents("b");
  EXPECT_NE(contents("a"), other);
  fs::rename(folder.path() / "b/two.h", folder.path() / "b/three.h");
  EXPECT_NE(contents("b"), other);
}

}  // namespace
}  // namespace mjcourse
