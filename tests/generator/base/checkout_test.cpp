#include "base/checkout.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

TEST(Checkout, IsTheInnerOneThatHoldsTheFolder) {
  const TemporaryFolder folder;
  const fs::path outer = folder.path() / "outer", inner = outer / "deep" / "inner";
  fs::create_directories(inner / "course");
  EXPECT_EQ(checkout_of(inner), std::nullopt);
  fs::create_directory(outer / ".git");
  EXPECT_EQ(checkout_of(outer), outer);
  EXPECT_EQ(checkout_of(inner / "course"), outer);
  write_file(inner / ".git", "gitdir: elsewhere\n");
  EXPECT_EQ(checkout_of(inner / "course"), inner);
  EXPECT_EQ(checkout_of(inner / "course" / "not" / "there"), inner);
  EXPECT_EQ(checkout_of(outer / "deep"), outer);
  fs::create_directory_symlink(inner, folder.path() / "link");
  EXPECT_EQ(checkout_of(folder.path() / "link" / "course"), inner);
  EXPECT_EQ(checkout_of(folder.path()), std::nullopt);
}

}  // namespace
}  // namespace mjcourse
