#include "page/foreign_files.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<std::string>;

// A site that a build wrote, and the next one, which is to take its place.
class ForeignFilesTest : public testing::Test {
 protected:
  ForeignFilesTest() : old_(folder_.path() / "old"), new_(folder_.path() / "new") {
    for (const fs::path& site : {old_, new_}) {
      write_file(site / "index.html", "x");
      write_file(site / "1-a/1.1-x.html", "x");
      write_site_list(OutFolder(site));
    }
  }
  // Of the user's.
  void add(const std::string& path) const { write_file(old_ / path, "mine"); }
  std::string refusal() const {
    try {
      move_foreign_files(OutFolder(old_), OutFolder(new_));
    } catch (const FolderRefused& refused) {
      std::string text = std::string(refused.what()) + " | " + refused.cure();
      for (std::size_t at; (at = text.find(folder_.path().string() + "/")) != text.npos;) {
        text.erase(at, folder_.path().string().size() + 1);
      }
      return text;
    }
    return "";
  }

  TemporaryFolder folder_;
  fs::path old_, new_;
};

TEST_F(ForeignFilesTest, AreNoneOfWhatABuildWrote) {
  EXPECT_EQ(read_file(old_ / kSiteList), ".mjcourse-site\n1-a/1.1-x.html\nindex.html\n");
  EXPECT_EQ(foreign_files(old_), Paths());
  EXPECT_EQ(foreign_files(old_, new_), Paths());
}

TEST_F(ForeignFilesTest, AreFilesAndWholeFoldersOfTheUsers) {
  add("CNAME");
  add(".git/objects/ab");
  add(".git/HEAD");
  add("1-a/notes.txt");
  fs::create_directories(old_ / "empty");
  EXPECT_EQ(foreign_files(old_, new_), (Paths{".git", "1-a/notes.txt", "CNAME", "empty"}));
}

// A folder that a build has no longer is the user's where the user put something there.
TEST_F(ForeignFilesTest, InAFolderThatTheNewSiteLacksAreMovedOneByOne) {
  fs::remove_all(new_ / "1-a");
  add("1-a/notes.txt");
  EXPECT_EQ(foreign_files(old_, new_), Paths{"1-a/notes.txt"});
}

TEST_F(ForeignFilesTest, MayBeLinksWhereverTheyLead) {
  fs::create_directory_symlink("/usr", old_ / "usr");
  fs::create_symlink("/nowhere", old_ / "lost");
  EXPECT_EQ(foreign_files(old_, new_), (Paths{"lost", "usr"}));
  move_foreign_files(OutFolder(old_), OutFolder(new_));
  EXPECT_TRUE(fs::is_symlink(new_ / "usr"));
  EXPECT_TRUE(fs::is_symlink(new_ / "lost"));
}

TEST_F(ForeignFilesTest, GoAlong) {
  add("CNAME");
  add(".git/HEAD");
  add("1-a/deep/notes.txt");
  move_foreign_files(OutFolder(old_), OutFolder(new_));
  EXPECT_EQ(read_file(new_ / "CNAME"), "mine");
  EXPECT_EQ(read_file(new_ / ".git/HEAD"), "mine");
  EXPECT_EQ(read_file(new_ / "1-a/deep/notes.txt"), "mine");
  EXPECT_EQ(foreign_files(old_), Paths());
  EXPECT_EQ(foreign_files(new_), (Paths{".git", "1-a/deep", "CNAME"}));
}

TEST_F(ForeignFilesTest, ThatTheNewSiteHasTooAreRefusedAndNothingIsMoved) {
  add("CNAME");
  add("1.2-y.html");
  write_file(new_ / "1.2-y.html", "built");
  EXPECT_EQ(refusal(),
            "no build wrote old/1.2-y.html, so it stays; but the new site has a file of that name "
            "| move yours elsewhere, or give it another name");
  EXPECT_EQ(read_file(old_ / "CNAME"), "mine");
  EXPECT_FALSE(fs::exists(new_ / "CNAME"));
  EXPECT_EQ(read_file(new_ / "1.2-y.html"), "built");
}

TEST_F(ForeignFilesTest, WhoseFolderIsAFileOfTheNewSiteAreRefused) {
  add("1-a/deep/notes.txt");
  write_file(old_ / "1-a/deep/page.html", "x");
  fs::remove(new_ / "1-a/1.1-x.html");
  fs::remove(new_ / "1-a");
  write_file(new_ / "1-a", "x");
  EXPECT_EQ(refusal(),
            "no build wrote old/1-a/deep, so it stays; but the new site has the file 1-a | move "
            "yours elsewhere, or give it another name");
}

TEST_F(ForeignFilesTest, AFileThatIsAFolderOfTheNewSiteIsRefused) {
  add("2-b");
  write_file(new_ / "2-b/2.1-z.html", "x");
  EXPECT_EQ(refusal(),
            "no build wrote old/2-b, so it stays; but the new site has a folder of that name | "
            "move yours elsewhere, or give it another name");
}

// A list may be a stranger's, and folders in each other without an end.
TEST_F(ForeignFilesTest, AreLookedForInTwoHundredFoldersOfEachOther) {
  std::string path = "d";
  for (int i = 1; i < 200; ++i) path += "/d";
  const auto list = [&] {
    write_file(old_ / kSiteList, std::string(kSiteList) + "\n" + path + "/x.html\n");
    add(path + "/x.html");
    refuse_unmovable_files(old_);
  };
  EXPECT_NO_THROW(list());
  path += "/d";
  try {
    list();
    ADD_FAILURE() << "was not refused";
  } catch (const FolderRefused& refused) {
    EXPECT_EQ(refused.what(),
              (old_ / path).string() + " lies in more than 200 folders of the site");
    EXPECT_STREQ(refused.cure().c_str(), "remove it, or name an empty or a new folder");
  }
}

TEST_F(ForeignFilesTest, AreNotLookedForWhereNobodyListsThem) {
  write_file(old_ / kSiteList, "");
  EXPECT_NO_THROW(refuse_unmovable_files(old_));
  EXPECT_NO_THROW(refuse_unmovable_files(folder_.path() / "nowhere"));
}

TEST_F(ForeignFilesTest, AreKnownOnlyOfASiteWithItsList) {
  EXPECT_TRUE(has_site_list(old_));
  EXPECT_FALSE(has_site_list(folder_.path()));
  fs::create_directory_symlink(old_, folder_.path() / "link");
  EXPECT_FALSE(has_site_list(folder_.path() / "link"));
  write_file(old_ / kSiteList, "");
  EXPECT_FALSE(has_site_list(old_));
  fs::remove(old_ / kSiteList);
  fs::create_symlink(new_ / kSiteList, old_ / kSiteList);
  EXPECT_FALSE(has_site_list(old_));
}

}  // namespace
}  // namespace mjcourse
