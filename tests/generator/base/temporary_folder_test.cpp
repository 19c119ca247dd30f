#include "base/temporary_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include "base/descriptor.h"
#include "base/files.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

TEST(TemporaryFolder, IsGoneWithAllThatIsInThere) {
  fs::path path;
  {
    const TemporaryFolder folder;
    path = folder.path();
    EXPECT_TRUE(fs::is_empty(path));
    EXPECT_EQ(fs::canonical(path), path);
    write_file(path / "a/b/file", "x");
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(TemporaryFolder, IsOfOneWorkAlone) {
  const TemporaryFolder one, other;
  EXPECT_NE(one.path(), other.path());
}

// As for a program that was told of a file in there, and cannot list it.
TEST(TemporaryFolder, LetsOthersThrough) {
  const TemporaryFolder folder;
  EXPECT_EQ(fs::status(folder.path()).permissions(),
            fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec);
}

TEST(TemporaryFolder, IsLockedForAsLongAsItsOwnerLives) {
  const TemporaryFolder folder;
  const Descriptor other(open(folder.path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  EXPECT_NE(flock(other.get(), LOCK_EX | LOCK_NB), 0);
}

}  // namespace
}  // namespace mjcourse
