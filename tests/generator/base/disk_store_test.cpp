#include "base/disk_store.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/blob.h"
#include "base/deep_folder.h"
#include "base/descriptor.h"
#include "base/files.h"
#include "base/lock_wait.h"
#include "base/prune_store.h"
#include "base/remove_folder.h"
#include "base/sha256.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

const std::string kAction = "ac/" + sha256("a question");

class DiskStoreTest : public testing::Test {
 protected:
  fs::path folder() const { return folder_.path() / "store"; }
  fs::path path_of(const std::string& name) const {
    const std::size_t hash = name.find('/') + 1;
    return folder() / name.substr(0, hash) / name.substr(hash, 2) / name.substr(hash + 2);
  }
  std::string bytes_of(const std::string& name) const {
    return read_file(path_of(name).string()).value();
  }
  static void age(const fs::path& path, std::chrono::hours hours) {
    fs::last_write_time(path, fs::file_time_type::clock::now() - hours);
  }

 private:
  TemporaryFolder folder_;
};

std::string put_blob(Store& store, const std::string& bytes) {
  const std::string name = "cas/" + sha256(bytes);
  EXPECT_TRUE(store.put(name, bytes));
  return name;
}

TEST_F(DiskStoreTest, GivesWhatWasPut) {
  const std::string bytes("a\0b\n", 4);
  {
    DiskStore store(folder());
    EXPECT_EQ(store.get(kAction), std::nullopt);
    EXPECT_TRUE(store.put(kAction, "first"));
    EXPECT_TRUE(store.put(kAction, bytes));
    EXPECT_EQ(store.get(put_blob(store, bytes)), bytes);
    EXPECT_EQ(store.get(put_blob(store, "")), "");
  }
  DiskStore store(folder());
  EXPECT_EQ(store.get(kAction), bytes);
  EXPECT_TRUE(store.notes().empty());
  EXPECT_TRUE(fs::is_empty(folder() / "tmp"));
}

TEST_F(DiskStoreTest, DropsWhatIsDamagedWithANote) {
  DiskStore store(folder());
  const std::string blob = put_blob(store, "a picture");
  store.put(kAction, "an answer");
  for (const std::string& name : {blob, kAction}) {
    const std::string whole = bytes_of(name);
    for (const std::string& damaged :
         {whole.substr(0, whole.size() - 1), whole + "x", "X" + whole.substr(1), std::string()}) {
      const std::size_t notes = store.notes().size();
      write_file(path_of(name), damaged);
      EXPECT_EQ(store.get(name), std::nullopt) << damaged;
      EXPECT_FALSE(fs::exists(path_of(name)));
      ASSERT_EQ(store.notes().size(), notes + 1);
      EXPECT_EQ(store.notes().back(),
                "the store's entry " + name + " was damaged; it is made again");
    }
  }
  write_file(path_of(blob), "another picture");
  EXPECT_EQ(store.get(put_blob(store, "a picture")), "a picture") << "it was damaged when put";
}

TEST_F(DiskStoreTest, MakesAnewWhereADeepFolderLies) {
  DiskStore store(folder());
  const std::string blob = put_blob(store, "a picture");
  for (const std::string& name : {blob, kAction}) {
    for (const bool is_asked : {true, false}) {
      fs::remove(path_of(name));
      const DeepFolder deep(path_of(name));
      if (is_asked) EXPECT_EQ(store.get(name), std::nullopt);
      EXPECT_TRUE(store.put(name, "a picture"));
      EXPECT_EQ(store.get(name), "a picture");
    }
  }
  for (const std::string& note : store.notes()) {
    EXPECT_TRUE(note.ends_with(" was damaged; it is made again")) << note;
  }
}

TEST_F(DiskStoreTest, MakesAnewWhatStandsWhereItsFoldersBelong) {
  DiskStore store(folder());
  for (const fs::path& place : {folder() / "ac", path_of(kAction).parent_path()}) {
    remove_folder(place);
    write_file(place, "a file");
    EXPECT_EQ(store.get(kAction), std::nullopt);
    EXPECT_TRUE(store.put(kAction, "an answer"));
    EXPECT_EQ(store.get(kAction), "an answer");
  }
  EXPECT_EQ(store.notes(), std::vector<std::string>());
}

// What is in the way of one entry does not keep the others from being kept. Where we are root, who
// may write everywhere, as somebody else.
TEST_F(DiskStoreTest, KeepsTheRestWhereOneEntryCannotBeWritten) {
  const std::string other = "ac/" + sha256("another question");
  { DiskStore(folder()).put(kAction, "an answer"); }
  const fs::path closed = path_of(kAction).parent_path();
  for (const fs::path& path :
       {folder().parent_path(), folder(), folder() / "ac", folder() / "tmp", folder() / "lock"}) {
    fs::permissions(path, fs::perms::all);
  }
  fs::permissions(closed, fs::perms::owner_read | fs::perms::owner_exec);
  const uid_t root = geteuid();
  if (root == 0) ASSERT_EQ(seteuid(54321), 0);
  std::vector<std::string> notes;
  {
    DiskStore store(folder());
    EXPECT_FALSE(store.put(kAction, "another answer"));
    EXPECT_FALSE(store.put(kAction, "another answer"));
    EXPECT_TRUE(store.put(other, "another"));
    EXPECT_EQ(store.get(other), "another");
    notes = store.notes();
  }
  if (root == 0) ASSERT_EQ(seteuid(root), 0);
  fs::permissions(closed, fs::perms::owner_all);
  EXPECT_EQ(notes, std::vector<std::string>{"results such as " + kAction + " are not kept, as " +
                                            path_of(kAction).string() +
                                            " is in the way: Permission denied; remove it"});
}

// Anybody who may read it can lock it, and keep it locked.
TEST_F(DiskStoreTest, IsReadWhereSomebodyKeepsItLocked) {
  { DiskStore(folder()).put(kAction, "an answer"); }
  Descriptor other(open((folder() / "lock").c_str(), O_RDONLY | O_CLOEXEC));
  ASSERT_EQ(flock(other.get(), LOCK_EX), 0);
  const std::string holder = lock_holder(other.get());
  {
    DiskStore store(folder(), {}, LockWait::none());
    EXPECT_FALSE(store.can_be_written());
    EXPECT_EQ(store.get(kAction), "an answer");
    EXPECT_FALSE(store.put("ac/" + sha256("another question"), "another"));
    EXPECT_EQ(store.notes(), std::vector<std::string>{
                                 "the store is read and not written: " + holder + " holds " +
                                 (folder() / "lock").string() + "; end it, or use another store"});
  }
  std::vector<std::string> told;
  const LockWait wait{.quiet = std::chrono::milliseconds(0), .tell = [&](const std::string& text) {
                        told.push_back(text);
                        other.reset();
                      }};
  DiskStore store(folder(), {}, wait);
  EXPECT_TRUE(store.can_be_written());
  EXPECT_EQ(store.notes(), std::vector<std::string>());
  EXPECT_EQ(told, std::vector<std::string>{"waiting for " + (folder() / "lock").string() +
                                           ", which " + holder + " holds"});
}

// What is not a store's is not taken for its own, and not removed.
TEST_F(DiskStoreTest, RefusesAFolderThatHoldsSomethingElse) {
  write_file(folder() / "thesis.txt", "years");
  const auto refuses = [&](const auto& open) {
    try {
      open();
      return std::string("nothing");
    } catch (const std::system_error& error) {
      return std::string(error.what());
    }
  };
  const std::string why =
      folder().string() + " is not a store, as it holds thesis.txt: Directory not empty";
  EXPECT_EQ(refuses([&] { DiskStore store(folder()); }), why);
  EXPECT_EQ(refuses([&] { prune_store(folder(), 0); }), why);
  fs::rename(folder() / "thesis.txt", folder() / "the\nsis\x1b]0;x\a");
  EXPECT_EQ(refuses([&] { DiskStore store(folder()); }),
            folder().string() +
                " is not a store, as it holds the\\nsis\\x1b]0;x\\x07: Directory not empty");
}

TEST_F(DiskStoreTest, ForgetsOnlyWhatIsItsOwn) {
  for (const char* file : {"tmp/notes.txt", "tmp/folder/abcdef", "ac/12/notes.txt"}) {
    write_file(folder() / file, "mine");
  }
  write_file(folder() / "tmp/abcdef", "unfinished");
  prune_store(folder(), 0);
  for (const char* file : {"tmp/notes.txt", "tmp/folder/abcdef", "ac/12/notes.txt"}) {
    EXPECT_TRUE(std::filesystem::exists(folder() / file)) << file;
  }
  EXPECT_FALSE(std::filesystem::exists(folder() / "tmp/abcdef"));
}

TEST_F(DiskStoreTest, TakesNoEntryForAnother) {
  DiskStore store(folder());
  const std::string other = "ac/" + std::string(64, '7');
  store.put(kAction, "an answer");
  store.put(other, "to another question");
  write_file(path_of(kAction), bytes_of(other));
  EXPECT_EQ(store.get(kAction), std::nullopt);
  EXPECT_EQ(store.get(other), "to another question");
}

TEST_F(DiskStoreTest, HasNothingUnderWhatIsNoName) {
  DiskStore store(folder());
  const fs::path kept = folder().parent_path() / "kept";
  fs::create_directory(kept);
  write_file(kept / "file", "mine");
  const std::string digits(62, '7');
  for (const std::string name :
       {"", "a", "ac/", "cas/a", "cas/ab/../../../../kept", "../kept", "kept", "lock"}) {
    EXPECT_EQ(store.get(name), std::nullopt) << name;
    EXPECT_FALSE(store.put(name, "bytes")) << name;
  }
  for (const std::string end : {"", "7", "7/", "7G", "777"}) {
    EXPECT_FALSE(store.put("ac/" + digits + end, "bytes")) << end;
  }
  EXPECT_TRUE(store.put("ac/" + digits + "7a", "bytes"));
  EXPECT_TRUE(fs::exists(kept / "file"));
  EXPECT_EQ(store.notes(), std::vector<std::string>());
}

TEST_F(DiskStoreTest, PassesOverWhatAnotherVersionWrote) {
  DiskStore store(folder());
  write_file(path_of(kAction), "mjcourse-store 1 " + sha256("an answer") + "\nan answer");
  EXPECT_EQ(store.get(kAction), std::nullopt);
  EXPECT_TRUE(store.notes().empty());
  store.put(kAction, "another");
  EXPECT_EQ(store.get(kAction), "another");
}

TEST_F(DiskStoreTest, ReadsNothingButFilesOfItsOwn) {
  DiskStore store(folder());
  const std::string blob = put_blob(store, "a picture");
  const fs::path elsewhere = folder().parent_path() / "elsewhere";
  write_file(elsewhere, "a picture");
  const std::vector<std::function<void(const fs::path&)>> places{
      [&](const fs::path& path) { fs::create_symlink(elsewhere, path); },
      [](const fs::path& path) { fs::create_symlink("/dev/zero", path); },
      [](const fs::path& path) { ASSERT_EQ(mkfifo(path.c_str(), 0600), 0); },
      [](const fs::path& path) { fs::create_directories(path / "a"); },
      [](const fs::path& path) {
        write_file(path, "");
        fs::resize_file(path, (std::uintmax_t{1} << 30) + 1);
      }};
  for (const auto& place : places) {
    fs::remove_all(path_of(blob));
    place(path_of(blob));
    EXPECT_EQ(store.get(blob), std::nullopt);
    EXPECT_EQ(put_blob(store, "a picture"), blob);
    EXPECT_EQ(store.get(blob), "a picture");
  }
  EXPECT_TRUE(fs::exists(elsewhere));
}

TEST_F(DiskStoreTest, GoesOnWhereItCannotWrite) {
  DiskStore store(folder());
  fs::remove(folder() / "tmp");
  EXPECT_FALSE(store.put(kAction, "an answer"));
  EXPECT_FALSE(store.put(kAction, "an answer"));
  ASSERT_EQ(store.notes().size(), 1);
  EXPECT_TRUE(store.notes()[0].starts_with("results are not kept from here on: "));
  EXPECT_TRUE(store.notes()[0].ends_with(": No such file or directory")) << store.notes()[0];
}

TEST_F(DiskStoreTest, ForgetsWhatWasNotUsedForLongest) {
  std::string old, used;
  {
    DiskStore store(folder());
    old = put_blob(store, std::string(1000, 'o'));
    used = put_blob(store, std::string(1000, 'u'));
    put_blob(store, std::string(1000, 'n'));
    age(path_of(old), std::chrono::hours(48));
    age(path_of(used), std::chrono::hours(72));
    store.get(used);
  }
  write_file(folder() / "tmp" / "AbCdEf", "left by a killed process");
  const auto pruned = prune_store(folder(), 2500);
  ASSERT_TRUE(pruned);
  EXPECT_EQ(pruned->removed.results, 1);
  EXPECT_EQ(pruned->removed.bytes, 1000);
  EXPECT_EQ(pruned->left.results, 2);
  EXPECT_EQ(pruned->left.bytes, 2000);
  EXPECT_FALSE(fs::exists(path_of(old)));
  EXPECT_TRUE(fs::exists(path_of(used)));
  EXPECT_TRUE(fs::is_empty(folder() / "tmp"));
}

TEST_F(DiskStoreTest, CountsWhatProgramsShare) {
  write_file(prepared_folder(folder()) / "a/entry/header.pch", std::string(8192, 'a'));
  write_file(prepared_folder(folder()) / "b/entry/header.pch", std::string(8192, 'b'));
  for (const char* name : {"a", "b"}) write_file(prepared_folder(folder()) / name / "current", "");
  age(prepared_folder(folder()) / "a/current", std::chrono::hours(1));
  const std::uintmax_t all = prune_store(folder(), UINT64_MAX)->left.bytes;
  EXPECT_GE(all, 16384);
  const auto pruned = prune_store(folder(), all - 1);
  EXPECT_EQ(pruned->removed.prepared, 1);
  EXPECT_EQ(pruned->left.prepared, 1);
  EXPECT_EQ(pruned->removed.results + pruned->left.results, 0);
  EXPECT_FALSE(fs::exists(prepared_folder(folder()) / "a"));
  EXPECT_TRUE(fs::exists(prepared_folder(folder()) / "b/entry/header.pch"));
}

TEST_F(DiskStoreTest, SaysWhatStandsWhereHeadersBelong) {
  write_file(prepared_folder(folder()), "a file");
  {
    DiskStore store(folder());
    ASSERT_EQ(store.notes().size(), 1);
    EXPECT_EQ(store.notes()[0], prepared_folder(folder()).string() +
                                    " is not a folder, so headers are compiled in each run; "
                                    "remove it");
    EXPECT_TRUE(store.put(kAction, "an answer"));
  }
  EXPECT_EQ(prune_store(folder(), UINT64_MAX)->left.results, 1);
  EXPECT_FALSE(fs::exists(prepared_folder(folder())));
  write_file(folder() / "cas", "a file");
  EXPECT_TRUE(prune_store(folder(), 0));
}

// Where we are root, who may write everywhere, as somebody else.
TEST_F(DiskStoreTest, IsReadWhereItCannotBeWritten) {
  {
    DiskStore store(folder());
    store.put(kAction, "an answer");
  }
  const auto add = fs::perm_options::add;
  fs::permissions(folder().parent_path(), fs::perms::group_exec | fs::perms::others_exec, add);
  fs::permissions(path_of(kAction), fs::perms::group_read | fs::perms::others_read, add);
  for (const fs::path& path : {folder() / "lock", folder() / "tmp", folder()}) {
    fs::permissions(path, fs::perms::all & ~(fs::perms::owner_write | fs::perms::group_write |
                                             fs::perms::others_write));
  }
  const uid_t root = geteuid();
  if (root == 0) ASSERT_EQ(seteuid(54321), 0);
  {
    DiskStore store(folder());
    EXPECT_FALSE(store.can_be_written());
    EXPECT_EQ(store.get(kAction), "an answer");
    EXPECT_FALSE(store.put("ac/" + sha256("another question"), "another"));
    EXPECT_EQ(store.notes(),
              std::vector<std::string>{"the store is read and not written: " +
                                       (folder() / "tmp").string() + ": Permission denied"});
  }
  if (root == 0) ASSERT_EQ(seteuid(root), 0);
  fs::permissions(folder(), fs::perms::owner_all, fs::perm_options::add);
  fs::permissions(folder() / "tmp", fs::perms::owner_all, fs::perm_options::add);
}

// A link in it leads to what is somebody's: nothing is written there, and nothing removed.
TEST_F(DiskStoreTest, GoesThroughNoLink) {
  const TemporaryFolder elsewhere;
  write_file(elsewhere.path() / "letters" / "one", "precious");
  for (const char* const kind : {"ac", "cas", "tmp", "prepared"}) {
    fs::remove_all(folder());
    fs::create_directories(folder());
    fs::create_symlink(elsewhere.path(), folder() / kind);
    EXPECT_THROW(DiskStore{folder()}, std::system_error) << kind;
    EXPECT_EQ(prune_store(folder(), 0)->removed.results, 0U);
    EXPECT_FALSE(fs::is_symlink(folder() / kind)) << kind;
    EXPECT_EQ(read_file(elsewhere.path() / "letters" / "one").value(), "precious") << kind;
  }
}

TEST_F(DiskStoreTest, GoesThroughNoLinkAmongItsEntries) {
  const TemporaryFolder elsewhere;
  DiskStore store(folder());
  store.put(kAction, "an answer");
  const fs::path letters = path_of(kAction).parent_path();
  fs::rename(letters, elsewhere.path() / "letters");
  fs::create_symlink(elsewhere.path() / "letters", letters);
  EXPECT_EQ(store.get(kAction), std::nullopt);
  fs::remove(elsewhere.path() / "letters" / path_of(kAction).filename());
  EXPECT_TRUE(store.put(kAction, "another answer"));
  EXPECT_EQ(store.get(kAction), "another answer");
  EXPECT_TRUE(fs::is_empty(elsewhere.path() / "letters"));
}

TEST_F(DiskStoreTest, IsNotPrunedWhileItIsUsed) {
  DiskStore store(folder());
  put_blob(store, "a picture");
  EXPECT_FALSE(prune_store(folder(), 0, LockWait::none()));
  EXPECT_TRUE(prune_store(folder() / "of nobody", 0, LockWait::none()));
}

TEST_F(DiskStoreTest, KeepsTheBytesOfABlob) {
  DiskStore store(folder());
  Blob blob("a picture");
  EXPECT_EQ(blob.hash(), sha256("a picture"));
  EXPECT_TRUE(blob.keep_in(store));
  EXPECT_EQ(blob.bytes(), "a picture");
  Blob known = Blob::known(blob.hash());
  EXPECT_TRUE(known.keep_in(store));
  EXPECT_EQ(known.bytes(), "a picture");
  Blob lost = Blob::known(sha256("another"));
  EXPECT_FALSE(lost.keep_in(store));
  fs::remove(path_of("cas/" + blob.hash()));
  EXPECT_THROW(blob.bytes(), std::runtime_error);
  EXPECT_TRUE(Blob("").empty());
}

}  // namespace
}  // namespace mjcourse
