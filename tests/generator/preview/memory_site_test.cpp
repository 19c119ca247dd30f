#include "preview/memory_site.h"

#include <gtest/gtest.h>

#include <ostream>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

class MemorySiteTest : public testing::Test {
 protected:
  std::optional<std::string> read(const std::string& path) const {
    return site_.read(path, course_);
  }

  const TemporaryFolder folder_;
  const std::filesystem::path course_ = folder_.path() / "course";
  MemorySite site_;
};

TEST_F(MemorySiteTest, HasWhatWasWritten) {
  site_.write("index.html", "home");
  site_.write("long.html", [](std::ostream& out) { out << "a long page"; });
  site_.write("figure-1.png", Blob("pixels"));
  EXPECT_EQ(read("index.html"), "home");
  EXPECT_EQ(read("long.html"), "a long page");
  EXPECT_EQ(read("figure-1.png"), "pixels");
  EXPECT_EQ(read("other.html"), std::nullopt);
  EXPECT_EQ(site_.hashes(),
            (std::map<std::string, std::string>{{"figure-1.png", Blob("pixels").hash()}}));
}

TEST_F(MemorySiteTest, ReadsWhatWasCopiedWhenItIsAskedFor) {
  write_file(course_ / "models/a.xml", "before");
  site_.copy(course_ / "models/a.xml", "models/a.xml");
  write_file(course_ / "models/a.xml", "after");
  EXPECT_EQ(read("models/a.xml"), "after");
  std::filesystem::remove(course_ / "models/a.xml");
  EXPECT_EQ(read("models/a.xml"), std::nullopt);
}

TEST_F(MemorySiteTest, GivesNothingFromOutsideOfTheCourse) {
  write_file(folder_.path() / "secret", "secret");
  write_file(course_ / "a.cpp", "");
  std::filesystem::create_symlink(folder_.path() / "secret", course_ / "link.cpp");
  for (const char* path : {"link.cpp", "../secret", "."}) {
    site_.copy(course_ / path, "copied");
    EXPECT_EQ(read("copied"), std::nullopt) << path;
  }
}

}  // namespace
}  // namespace mjcourse
