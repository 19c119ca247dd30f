#include "base/prune_store.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "base/deep_folder.h"
#include "base/descriptor.h"
#include "base/disk_store.h"
#include "base/files.h"
#include "base/remove_folder.h"
#include "base/sha256.h"
#include "base/store_layout.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

const std::string kResult = "ac/" + sha256("a question");

void set_time(const fs::path& path, std::time_t seconds) {
  const timespec times[2] = {{seconds, 0}, {seconds, 0}};
  ASSERT_EQ(utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
}

class PruneStoreTest : public testing::Test {
 protected:
  PruneStoreTest() { put(kResult, "an answer"); }
  ~PruneStoreTest() override { remove_folder(folder()); }

  fs::path folder() const { return folder_.path() / "store"; }
  fs::path path_of(const std::string& name) const { return StorePlace::of(name).in(folder()); }
  void put(const std::string& name, const std::string& bytes) const {
    EXPECT_TRUE(DiskStore(folder()).put(name, bytes));
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(PruneStoreTest, GoesNoDeeperThanAStoreWrites) {
  const DeepFolder first(folder() / "ac" / "aa"), second(folder() / "cas" / "deep"),
      third(folder() / "tmp" / "deepxx");
  const auto pruned = prune_store(folder(), 0);
  EXPECT_EQ(pruned->removed.results, 1U);
  EXPECT_FALSE(fs::exists(path_of(kResult)));
  const std::string ac = (folder() / "ac" / "aa" / "d").string(),
                    tmp = (folder() / "tmp" / "deepxx").string();
  EXPECT_EQ(pruned->notes,
            std::vector<std::string>{"no store has written " + tmp +
                                     " and 2 more, so it stays; remove it where it is nobody's"});
  EXPECT_TRUE(fs::exists(ac));
}

TEST_F(PruneStoreTest, RemovesWhatLiesWhereAResultBelongs) {
  fs::remove(path_of(kResult));
  const DeepFolder deep(path_of(kResult));
  const std::string large = "cas/" + std::string(64, '7');
  write_file(path_of(large), "");
  fs::resize_file(path_of(large), (std::uintmax_t{1} << 40));
  put("ac/" + sha256("another question"), "another answer");
  const auto pruned = prune_store(folder(), 1'000'000);
  EXPECT_EQ(pruned->notes,
            std::vector<std::string>{"what lay where a result belongs was none, and is removed: " +
                                     path_of(kResult).string() + " and 1 more"});
  EXPECT_FALSE(fs::exists(path_of(kResult)));
  EXPECT_FALSE(fs::exists(path_of(large)));
  EXPECT_EQ(pruned->left.results, 1U) << "the sizes of others do not count";
}

TEST_F(PruneStoreTest, RemovesADeepFolderOfHeaders) {
  const DeepFolder deep(prepared_folder(folder()) / "entry");
  const auto pruned = prune_store(folder(), 0);
  EXPECT_EQ(pruned->removed.prepared, 1U);
  EXPECT_EQ(pruned->notes, std::vector<std::string>());
  EXPECT_TRUE(fs::is_empty(prepared_folder(folder())));
}

// A time that is to come keeps nothing for ever.
TEST_F(PruneStoreTest, TakesATimeToComeForNone) {
  const std::string used = "ac/" + sha256("another question");
  put(used, "an answer");
  for (const std::time_t time : {std::time(nullptr) + 1'000'000, std::time_t{1} << 40}) {
    put(kResult, "an answer");
    set_time(path_of(kResult), time);
    write_file(prepared_folder(folder()) / "a/current", "");
    set_time(prepared_folder(folder()) / "a/current", time);
    const auto pruned = prune_store(folder(), fs::file_size(path_of(used)));
    EXPECT_EQ(pruned->removed.results, 1U) << time;
    EXPECT_EQ(pruned->removed.prepared, 1U) << time;
    EXPECT_TRUE(fs::exists(path_of(used))) << time;
  }
  set_time(path_of(used), std::time_t{1} << 40);
  EXPECT_EQ(DiskStore(folder()).get(used), "an answer");
  struct stat status {};
  ASSERT_EQ(lstat(path_of(used).c_str(), &status), 0);
  EXPECT_LE(status.st_mtime, std::time(nullptr) + 1) << "and what is used has a time again";
}

// Where we are root, who may do all, as somebody else.
TEST_F(PruneStoreTest, RemovesTheRestWhereItMayNotRemoveSomething) {
  const std::string other = "ac/" + sha256("another question");
  put(other, "an answer");
  const fs::path closed = path_of(kResult).parent_path();
  const uid_t root = geteuid();
  for (const fs::path& path : {folder().parent_path(), folder(), folder() / "ac",
                               path_of(other).parent_path(), folder() / "lock"}) {
    fs::permissions(path, fs::perms::all);
  }
  fs::permissions(closed, fs::perms::owner_read | fs::perms::owner_exec);
  if (root == 0) {
    fs::permissions(closed, fs::perms::none);
    ASSERT_EQ(seteuid(54321), 0);
  }
  const auto pruned = prune_store(folder(), 0);
  if (root == 0) ASSERT_EQ(seteuid(root), 0);
  fs::permissions(closed, fs::perms::owner_all);
  EXPECT_EQ(pruned->removed.results, 1U);
  EXPECT_FALSE(fs::exists(path_of(other)));
  EXPECT_TRUE(fs::exists(path_of(kResult)));
  const std::string what = root == 0 ? closed.string() : path_of(kResult).string();
  EXPECT_EQ(pruned->notes,
            std::vector<std::string>{"the store cannot remove or read " + what +
                                     ": Permission denied; ask its owner to remove it"});
}

TEST_F(PruneStoreTest, FollowsNoLinkAmongItsFolders) {
  const TemporaryFolder elsewhere;
  const fs::path kept = elsewhere.path() / std::string(62, 'a');
  write_file(kept, "precious");
  fs::create_symlink(elsewhere.path(), folder() / "ac" / "aa");
  EXPECT_EQ(prune_store(folder(), 0)->removed.results, 1U);
  EXPECT_TRUE(fs::exists(kept));
  EXPECT_FALSE(fs::is_symlink(folder() / "ac" / "aa"));
}

TEST_F(PruneStoreTest, SaysWhomItWaitsFor) {
  Descriptor other(open((folder() / "lock").c_str(), O_RDONLY | O_CLOEXEC));
  ASSERT_EQ(flock(other.get(), LOCK_EX), 0);
  EXPECT_FALSE(prune_store(folder(), 0, LockWait::none()));
  std::vector<std::string> told;
  const std::string holder = lock_holder(other.get());
  const LockWait wait{.quiet = std::chrono::milliseconds(0), .tell = [&](const std::string& text) {
                        told.push_back(text);
                        other.reset();
                      }};
  EXPECT_EQ(prune_store(folder(), 0, wait)->removed.results, 1U);
  EXPECT_EQ(told, std::vector<std::string>{"waiting for " + (folder() / "lock").string() +
                                           ", which " + holder + " holds"});
}

}  // namespace
}  // namespace mjcourse
