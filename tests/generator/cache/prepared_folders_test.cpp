#include "cache/prepared_folders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "base/cancellation.h"
#include "base/deep_folder.h"
#include "base/file_lock.h"
#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

class PreparedFoldersTest : public testing::Test {
 protected:
  PreparedFoldersTest() { write_file(input_, "1"); }

  // The bytes of the entry, which are the input's and `more`; asked for in a new run.
  std::string get(const std::string& request, const std::string& more = "",
                  std::uintmax_t most_bytes = 1000) {
    PreparedFolders folders(
        cache_, [](const std::string& name) { return name; }, most_bytes);
    const auto entry = folders.get(request, [&](const fs::path&, const fs::path& staging) {
      ++made_;
      write_file(staging / "a", bytes(input_) + more);
      return PreparedFolders::Made{worked_, {input_.string()}};
    });
    return entry ? bytes(entry->folder / "a") : "nothing";
  }
  static std::string bytes(const fs::path& file) {
    return DiskFiles(file.parent_path()).read(file.filename().string()).value();
  }
  std::ptrdiff_t requests() const {
    return std::distance(fs::directory_iterator(cache_), fs::directory_iterator());
  }

  TemporaryFolder folder_;
  fs::path input_ = folder_.path() / "input with blanks", cache_ = folder_.path() / "cache";
  bool worked_ = true;
  int made_ = 0;  // how many times
};

TEST_F(PreparedFoldersTest, AreMadeOnceForOneInput) {
  EXPECT_EQ(get("x"), "1");
  EXPECT_EQ(get("x"), "1");
  EXPECT_EQ(made_, 1);
  write_file(input_, "2");
  EXPECT_EQ(get("x"), "2");
  EXPECT_EQ(made_, 2);
  fs::remove(input_);
  write_file(input_, "2");
  EXPECT_EQ(get("x"), "2");
  EXPECT_EQ(made_, 2);
}

TEST_F(PreparedFoldersTest, GoThroughNoLink) {
  EXPECT_EQ(get("x"), "1");
  const fs::path request = fs::directory_iterator(cache_)->path();
  const fs::path elsewhere = folder_.path() / "elsewhere";
  fs::remove_all(request);
  write_file(elsewhere / "folder" / "file", "precious");
  fs::create_symlink(elsewhere, request);
  fs::create_symlink(elsewhere, cache_ / "another");
  EXPECT_EQ(get("x", "", 0), "1");
  EXPECT_EQ(bytes(elsewhere / "folder" / "file"), "precious");
  EXPECT_EQ(std::distance(fs::directory_iterator(elsewhere), {}), 1);
}

// What a link leads to would be open to the programs that are compiled with the entry.
TEST_F(PreparedFoldersTest, AreNotFoundBehindALink) {
  EXPECT_EQ(get("x"), "1");
  const fs::path request = fs::directory_iterator(cache_)->path();
  const fs::path elsewhere = folder_.path() / "elsewhere";
  fs::rename(request, elsewhere);
  const auto before = fs::last_write_time(elsewhere / "current");
  fs::create_symlink(elsewhere, request);
  PreparedFolders folders(
      cache_, [](const std::string& name) { return name; }, 1000);
  EXPECT_EQ(folders.find("x"), nullptr);
  EXPECT_EQ(get("x"), "1");
  EXPECT_EQ(made_, 2);
  EXPECT_EQ(fs::last_write_time(elsewhere / "current"), before);
  // The entry itself, and a file in it.
  for (const bool whole : {true, false}) {
    fs::path entry;
    for (const auto& one : fs::directory_iterator(request)) {
      if (one.is_directory()) entry = one.path();
    }
    const fs::path linked = whole ? entry : entry / "a";
    fs::rename(linked, elsewhere / (whole ? "folder" : "file"));
    fs::create_symlink(elsewhere / (whole ? "folder" : "file"), linked);
    EXPECT_EQ(get("x"), "1");
    EXPECT_EQ(made_, whole ? 3 : 4);
  }
}

TEST_F(PreparedFoldersTest, AreMadeAnewWhereADeepFolderLies) {
  EXPECT_EQ(get("x"), "1");
  const fs::path request = fs::directory_iterator(cache_)->path();
  const DeepFolder first(request / "making"), second(cache_ / "another");
  write_file(cache_ / "another" / "file", "x");
  write_file(input_, "2");
  EXPECT_EQ(get("x", "", 0), "2");
  EXPECT_EQ(requests(), 1);
}

// A time that is to come keeps nothing for ever.
TEST_F(PreparedFoldersTest, GoFirstWhereTheirTimeIsToCome) {
  write_file(cache_ / "another" / "current", std::string(1000, 'x'));
  write_file(cache_ / "old" / "current", "x");
  const auto now = fs::file_time_type::clock::now();
  fs::last_write_time(cache_ / "another" / "current", now + std::chrono::hours(1000));
  fs::last_write_time(cache_ / "old" / "current", now - std::chrono::hours(1000));
  EXPECT_EQ(get("x"), "1");
  EXPECT_FALSE(fs::exists(cache_ / "another"));
  EXPECT_TRUE(fs::exists(cache_ / "old"));
}

// Anybody may hold a lock in a shared store.
TEST_F(PreparedFoldersTest, AreNotWaitedForForEver) {
  EXPECT_EQ(get("x"), "1");
  const FileLock held(fs::directory_iterator(cache_)->path() / "lock");
  write_file(input_, "2");
  PreparedFolders folders(
      cache_, [](const std::string& name) { return name; }, 1000, std::chrono::milliseconds(0));
  EXPECT_EQ(folders.get("x",
                        [](const fs::path&, const fs::path&) {
                          ADD_FAILURE() << "made without the lock";
                          return std::nullopt;
                        }),
            nullptr);
}

// In a store that somebody else has filled.
TEST_F(PreparedFoldersTest, AreMadeAnewWhereLinksLieInThem) {
  EXPECT_EQ(get("x"), "1");
  const fs::path request = fs::directory_iterator(cache_)->path();
  const fs::path elsewhere = folder_.path() / "elsewhere";
  write_file(elsewhere / "file", "precious");
  for (const fs::path& target : {elsewhere / "file", elsewhere / "missing", elsewhere}) {
    fs::remove_all(request);
    fs::create_directory(request);
    for (const char* name : {"current", "lock", "making", "header.hpp"}) {
      fs::create_symlink(target, request / name);
    }
    EXPECT_EQ(get("x"), "1") << target;
    EXPECT_FALSE(fs::exists(fs::symlink_status(request / "header.hpp"))) << target;
    EXPECT_EQ(bytes(elsewhere / "file"), "precious") << target;
    EXPECT_EQ(std::distance(fs::directory_iterator(elsewhere), {}), 1) << target;
  }
}

TEST_F(PreparedFoldersTest, AreFoundByWhoDoesNotMakeThem) {
  EXPECT_FALSE(PreparedFolders(cache_).find("x"));
  EXPECT_EQ(get("x"), "1");
  PreparedFolders folders(cache_);
  EXPECT_EQ(bytes(folders.find("x")->folder / "a"), "1");
  write_file(input_, "2");
  EXPECT_FALSE(PreparedFolders(cache_).find("x"));
  EXPECT_TRUE(folders.find("x"));  // in one run, all is compiled with the same
}

TEST_F(PreparedFoldersTest, AreFoundWhereInputsLieElsewhere) {
  const PreparedFolders::Make make = [](const fs::path&, const fs::path& staging) {
    write_file(staging / "a", "");
    return PreparedFolders::Made{true, {"/virtual/input"}};
  };
  const auto find = [&](const fs::path& place) {
    PreparedFolders folders(cache_, [&](const std::string&) { return place.string(); });
    return folders.get("x", make);
  };
  EXPECT_EQ(find(input_)->inputs, std::vector{input_.string()});
  const fs::path moved = folder_.path() / "moved";
  fs::rename(input_, moved);
  EXPECT_EQ(find(moved)->inputs, std::vector{moved.string()});
}

TEST_F(PreparedFoldersTest, AreNotTriedAgainWhereTheInputsDoNotGiveThem) {
  worked_ = false;
  EXPECT_EQ(get("x"), "nothing");
  EXPECT_EQ(get("x"), "nothing");
  EXPECT_EQ(made_, 1);
  worked_ = true;
  write_file(input_, "2");
  EXPECT_EQ(get("x"), "2");
}

TEST_F(PreparedFoldersTest, AreTriedAgainWhereTheyCouldNotBeTried) {
  PreparedFolders folders(cache_);
  EXPECT_FALSE(folders.get("x", [](const fs::path&, const fs::path&) {
    return std::optional<PreparedFolders::Made>();
  }));
  EXPECT_EQ(get("x"), "1");
}

// All that wait for them end, and the next one begins anew.
TEST_F(PreparedFoldersTest, AreGivenUpWhereTheWorkIsCancelled) {
  PreparedFolders folders(cache_);
  const PreparedFolders::Make cancelled =
      [](const fs::path&, const fs::path&) -> std::optional<PreparedFolders::Made> {
    throw Cancelled();
  };
  EXPECT_THROW(folders.get("x", cancelled), Cancelled);
  EXPECT_THROW(folders.get("x", cancelled), Cancelled);
  EXPECT_EQ(get("x"), "1");
}

TEST_F(PreparedFoldersTest, ClearUpAfterAMakerThatWasKilled) {
  get("x");
  const fs::path request = fs::directory_iterator(cache_)->path();
  write_file(request / "making/half", "0");
  fs::remove(request / "current");
  EXPECT_EQ(get("x"), "1");
  EXPECT_FALSE(fs::exists(request / "making"));
}

TEST_F(PreparedFoldersTest, LoseWhatWasNotUsedForLongest) {
  get("a");
  get("b");
  get("a");
  EXPECT_EQ(made_, 2);
  get("c", std::string(1000, '.'));  // which alone is too much
  EXPECT_EQ(requests(), 1);
  const auto size = [&] {
    std::uintmax_t all = 0;
    for (const auto& file : fs::recursive_directory_iterator(cache_)) {
      if (file.is_regular_file()) all += file.file_size();
    }
    return all;
  };
  fs::remove_all(cache_);
  get("a");
  const std::uintmax_t one = size();
  get("b");
  get("a");
  made_ = 0;
  get("c", "", 2 * one);
  EXPECT_EQ(requests(), 2);
  get("a");
  EXPECT_EQ(made_, 1);  // c; b is gone
}

TEST_F(PreparedFoldersTest, AreLostWhereALinkIsInTheWay) {
  EXPECT_EQ(get("x"), "1");
  const fs::path old = fs::directory_iterator(cache_)->path();
  fs::remove(old / "lock");
  fs::create_symlink(folder_.path() / "elsewhere", old / "lock");
  EXPECT_EQ(get("y", "", 0), "1");
  EXPECT_FALSE(fs::exists(old));
  EXPECT_FALSE(fs::exists(folder_.path() / "elsewhere"));
}

TEST_F(PreparedFoldersTest, AreNotThereWithoutAFolder) {
  PreparedFolders folders(std::nullopt);
  EXPECT_FALSE(folders.get(
      "x", [](const fs::path&, const fs::path&) -> std::optional<PreparedFolders::Made> {
        ADD_FAILURE();
        return std::nullopt;
      }));
}

}  // namespace
}  // namespace mjcourse
