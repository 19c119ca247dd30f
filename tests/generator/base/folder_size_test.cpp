#include "base/folder_size.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
constexpr std::uint64_t kPage = 4096;

FolderSize size_of(const fs::path& path, std::uint64_t most = 1000) {
  FolderSize size;
  add_size(path.string(), most, size);
  return size;
}

TEST(FolderSize, IsOfAllThatIsInThere) {
  const TemporaryFolder folder;
  const std::uint64_t before = size_of(folder.path()).bytes;
  write_file(folder.path() / "a/b/file", std::string(10 * kPage, 'x'));
  write_file(folder.path() / "file", "x");
  const FolderSize size = size_of(folder.path());
  EXPECT_EQ(size.entries, 4U);
  EXPECT_GE(size.bytes, before + 11 * kPage);
  EXPECT_LT(size.bytes, before + 20 * kPage);
}

TEST(FolderSize, IsAddedToWhatWasThere) {
  const TemporaryFolder folder;
  write_file(folder.path() / "file", std::string(kPage, 'x'));
  FolderSize size{100, 7};
  add_size((folder.path() / "file").string(), 1000, size);
  EXPECT_EQ(size.bytes, 100 + kPage);
  EXPECT_EQ(size.entries, 7U);
}

TEST(FolderSize, IsOfALinkAndNotOfWhereItLeads) {
  const TemporaryFolder folder;
  fs::create_directory_symlink("/usr", folder.path() / "link");
  fs::create_symlink("/nowhere", folder.path() / "lost");
  EXPECT_EQ(size_of(folder.path()).entries, 2U);
}

TEST(FolderSize, IsNothingOfWhatIsNotThere) {
  const TemporaryFolder folder;
  const FolderSize size = size_of(folder.path() / "missing");
  EXPECT_EQ(size.entries, 0U);
  EXPECT_EQ(size.bytes, 0U);
}

TEST(FolderSize, IsCountedNoFurtherThanItMatters) {
  const TemporaryFolder folder;
  for (int i = 0; i < 20; ++i) write_file(folder.path() / std::to_string(i), "");
  EXPECT_EQ(size_of(folder.path(), 5).entries, 6U);
}

TEST(FolderSize, OfAVeryDeepFolderIsMoreThanAny) {
  const TemporaryFolder folder;
  fs::path deep = folder.path();
  for (int i = 0; i < 99; ++i) deep /= "d";
  fs::create_directories(deep);
  EXPECT_EQ(size_of(folder.path()).entries, 99U);
  fs::create_directories(deep / "d" / "d");
  EXPECT_EQ(size_of(folder.path()).entries, 1001U);
}

}  // namespace
}  // namespace mjcourse
