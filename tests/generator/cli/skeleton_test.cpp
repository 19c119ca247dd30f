#include "cli/skeleton.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace mjcourse {
namespace {

TEST(Skeleton, IsFilledAtItsMarksAndNowhereElse) {
  const MemoryFiles assets(std::map<std::string, std::string>{
      {"skeleton/a.txt", "@name@, v4@x a@b.c @ name@ @name@@\n"}});
  EXPECT_EQ(filled_skeleton(assets, "a.txt", {{"name", "@other@"}}),
            "@other@, v4@x a@b.c @ name@ @other@@\n");
}

std::string failure_of(const std::string& path) {
  const MemoryFiles assets(std::map<std::string, std::string>{{"skeleton/a.txt", "@nmae@\n"}});
  try {
    return filled_skeleton(assets, path, {{"name", "x"}});
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(Skeleton, IsToKnowItsMarks) {
  EXPECT_EQ(failure_of("a.txt"), "skeleton/a.txt has the mark @nmae@, which means nothing");
  EXPECT_EQ(failure_of("b.txt"),
            "the skeletons are not installed: skeleton/b.txt: No such file or directory");
}

}  // namespace
}  // namespace mjcourse
