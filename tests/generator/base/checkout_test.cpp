#include "base/checkout.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

TEST(Checkout, IsTheOuterOneThatHoldsTheFolder) {
  const TemporaryFolder folder;
  const fs::path outer = folder.path() / "outer", inner = outer / "deep" / "inner";
  fs::create_directories(inner / "course");
  EXPECT_EQ(checkout_of(inner), std::nullopt);
  write_file(inner / ".git", "gitdir: elsewhere\n");
  EXPECT_EQ(checkout_of(inner / "course"), inner);
  EXPECT_EQ(checkout_of(inner / "course" / "not" / "there"), inner);
  EXPECT_EQ(checkout_of(outer / "deep"), std::nullopt);
  fs::create_directory_symlink(inner, folder.path() / "link");
  EXPECT_EQ(checkout_of(folder.path() / "link" / "course"), inner);
  fs::create_directory(outer / ".git");
  EXPECT_EQ(checkout_of(outer), outer);
  EXPECT_EQ(checkout_of(inner / "course"), outer) << "a submodule";
  EXPECT_EQ(checkout_of(folder.path()), std::nullopt);
}

TEST(Checkout, IsNoHomeFolder) {
  const TemporaryFolder home;
  const char* const known = std::getenv("HOME");
  const std::string before = known == nullptr ? "" : known;
  fs::create_directories(home.path() / ".git");
  fs::create_directories(home.path() / "work/course/.git");
  setenv("HOME", home.path().c_str(), 1);
  EXPECT_EQ(checkout_of(home.path() / "work/course"), home.path() / "work/course");
  EXPECT_EQ(checkout_of(home.path() / "work"), std::nullopt);
  setenv("HOME", before.c_str(), 1);
}

}  // namespace
}  // namespace mjcourse
