#include "cache/fingerprint_cache.h"

#include <gtest/gtest.h>

#include <thread>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "memory_store.h"

namespace mjcourse {
namespace {

using namespace std::chrono_literals;

class FingerprintCacheTest : public testing::Test {
 protected:
  FingerprintCacheTest() {
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

TEST_F(FingerprintCacheTest, BelievesUnchangedFiles) {
  FingerprintCache cache;
  EXPECT_EQ(cache.find(path(), status()), std::nullopt);
  cache.keep(path(), status(), "print");
  EXPECT_EQ(cache.find(path(), status()), "print");
  write_file(path(), "two");
  EXPECT_EQ(cache.find(path(), status()), std::nullopt);
}

TEST_F(FingerprintCacheTest, DoNotKeepWhatWasChangedJustNow) {
  write_file(path(), "two");
  FingerprintCache cache;
  cache.keep(path(), status(), "print");
  EXPECT_EQ(cache.find(path(), status()), std::nullopt);
}

TEST_F(FingerprintCacheTest, PersistsForTheNextRun) {
  FingerprintCache cache;
  cache.keep(path(), status(), "print");
  cache.write(store_, folder_.path());

  FingerprintCache later(1h);
  later.read(store_, folder_.path());
  EXPECT_EQ(later.find_fresh(path()), std::nullopt) << "nobody has looked at it";
  EXPECT_EQ(later.find(path(), status()), "print");
  FingerprintCache elsewhere;
  elsewhere.read(store_, folder_.path() / "another");
  EXPECT_EQ(elsewhere.find(path(), status()), std::nullopt);
}

TEST_F(FingerprintCacheTest, AreForgottenWhereNobodyAsksForThem) {
  FingerprintCache cache;
  cache.keep(path(), status(), "print");
  cache.write(store_, folder_.path());
  FingerprintCache later;
  later.read(store_, folder_.path());
  later.write(store_, folder_.path());
  FingerprintCache last;
  last.read(store_, folder_.path());
  EXPECT_EQ(last.find(path(), status()), std::nullopt);
}

}  // namespace
}  // namespace mjcourse
