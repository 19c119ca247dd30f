#include "cache/fingerprint_cache.h"

#include <gtest/gtest.h>

#include <thread>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

using namespace std::chrono_literals;

class KnownFilesTest : public testing::Test {
 protected:
  KnownFilesTest() {
    write_file(path(), "one");
    std::this_thread::sleep_for(50ms);
  }

  std::string path() const { return (folder_.path() / "a b").string(); }
  struct stat status() const {
    struct stat status {};
    EXPECT_EQ(stat(path().c_str(), &status), 0);
    return status;
  }

  TemporaryFolder folder_;
  MemoryStore store_;
};

TEST_F(KnownFilesTest, BelieveWhatHasNotChanged) {
  FingerprintCache files;
  EXPECT_EQ(files.find(path(), status()), std::nullopt);
  files.keep(path(), status(), "print");
  EXPECT_EQ(files.find(path(), status()), "print");
  write_file(path(), "two");
  EXPECT_EQ(files.find(path(), status()), std::nullopt);
}

TEST_F(KnownFilesTest, DoNotKeepWhatWasChangedJustNow) {
  write_file(path(), "two");
  FingerprintCache files;
  files.keep(path(), status(), "print");
  EXPECT_EQ(files.find(path(), status()), std::nullopt);
}

TEST_F(KnownFilesTest, AreKeptForTheNextRun) {
  FingerprintCache files;
  files.keep(path(), status(), "print");
  files.write(store_, folder_.path());

  FingerprintCache later(1h);
  later.read(store_, folder_.path());
  EXPECT_EQ(later.find_fresh(path()), std::nullopt) << "nobody has looked at it";
  EXPECT_EQ(later.find(path(), status()), "print");
  FingerprintCache elsewhere;
  elsewhere.read(store_, folder_.path() / "another");
  EXPECT_EQ(elsewhere.find(path(), status()), std::nullopt);
}

TEST_F(KnownFilesTest, AreForgottenWhereNobodyAsksForThem) {
  FingerprintCache files;
  files.keep(path(), status(), "print");
  files.write(store_, folder_.path());
  FingerprintCache later;
  later.read(store_, folder_.path());
  later.write(store_, folder_.path());
  FingerprintCache last;
  last.read(store_, folder_.path());
  EXPECT_EQ(last.find(path(), status()), std::nullopt);
}

}  // namespace
}  // namespace mjcourse
