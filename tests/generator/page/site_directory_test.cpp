#include "page/site_directory.h"

#include <gtest/gtest.h>

#include <map>
#include <ostream>

#include "base/beneath.h"
#include "base/files.h"
#include "base/temporary_folder.h"
#include "page/foreign_files.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Texts = std::map<std::string, std::string>;

class SiteDirectoryTest : public testing::Test {
 protected:
  // Build a site of one page.
  void build(const std::string& text) const {
    SiteDirectory directory(site_);
    directory.write("page.html", text);
    directory.commit();
  }

  // The site's files without the list of them.
  Texts files() const {
    Texts texts;
    for (const auto& entry : fs::recursive_directory_iterator(site_)) {
      const std::string path = fs::relative(entry.path(), site_);
      if (entry.is_regular_file() && path != kSiteList) {
        texts[path] = read_file(entry.path()).value();
      }
    }
    return texts;
  }

  // What opening the site's folder throws.
  std::string refusal() const {
    try {
      const SiteDirectory directory(site_);
    } catch (const FolderRefused& refused) {
      return refused.what() + ("; " + refused.cure());
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  // What building a site of the file `path` throws.
  std::string refusal_of(const std::string& path) const {
    try {
      SiteDirectory directory(site_);
      directory.write(path, "new");
      directory.commit();
    } catch (const FolderRefused& refused) {
      return refused.what() + ("; " + refused.cure());
    }
    return "";
  }

  TemporaryFolder folder_;
  fs::path site_ = folder_.path() / "out" / "site";
};

TEST_F(SiteDirectoryTest, WritesANewSite) {
  write_file(folder_.path() / "assets" / "deep" / "a.css", "css");
  {
    SiteDirectory directory(site_);
    directory.write("1-a/x.html", "x");
    directory.copy_own(folder_.path() / "assets", "assets");
    EXPECT_FALSE(fs::exists(site_));
    directory.commit();
  }
  EXPECT_EQ(files(), (Texts{{"1-a/x.html", "x"}, {"assets/deep/a.css", "css"}}));
}

TEST_F(SiteDirectoryTest, ReplacesTheOldSiteAsAWhole) {
  build("old");
  {
    SiteDirectory directory(site_);
    directory.write("other.html", "new");
    EXPECT_EQ(files(), (Texts{{"page.html", "old"}}));
    directory.commit();
    EXPECT_EQ(files(), (Texts{{"other.html", "new"}}));
  }
  EXPECT_EQ(files(), (Texts{{"other.html", "new"}}));
}

TEST_F(SiteDirectoryTest, LeavesTheOldSiteUntilItIsDone) {
  build("old");
  {
    SiteDirectory directory(site_);
    directory.write("page.html", "half of the new");
  }
  EXPECT_EQ(files(), (Texts{{"page.html", "old"}}));
}

TEST_F(SiteDirectoryTest, LeavesNothingBesideTheSite) {
  build("old");
  build("new");
  for (const auto& entry : fs::directory_iterator(site_.parent_path())) {
    const std::string name = entry.path().filename();
    EXPECT_TRUE(name == "site" || name == ".site.lock") << name;
  }
}

TEST_F(SiteDirectoryTest, RemovesWhatAKilledBuildLeft) {
  write_file(site_.parent_path() / ".site.building" / "stale.html", "stale");
  build("new");
  EXPECT_EQ(files(), (Texts{{"page.html", "new"}}));
}

TEST_F(SiteDirectoryTest, RefusesAFolderThatNoBuildMade) {
  write_file(site_ / "precious.txt", "work of years");
  EXPECT_EQ(refusal(), site_.string() +
                           " holds something that no build made, and would be replaced; "
                           "name an empty or a new folder");
  EXPECT_EQ(files(), (Texts{{"precious.txt", "work of years"}}));
}

TEST_F(SiteDirectoryTest, RefusesAFile) {
  write_file(site_, "a file");
  EXPECT_NE(refusal(), "");
  EXPECT_TRUE(fs::is_regular_file(site_));
}

TEST_F(SiteDirectoryTest, ReadsNoListWithoutAnEnd) {
  build("old");
  fs::resize_file(site_ / kSiteList, std::uintmax_t{1} << 40);
  EXPECT_EQ(refusal(), site_.string() +
                           " was written by an earlier mjcourse, which kept no list of its files; "
                           "take what is yours out of it and remove it, or name an empty or a new "
                           "folder");
}

TEST_F(SiteDirectoryTest, TakesAnEmptyFolder) {
  fs::create_directories(site_);
  build("new");
  EXPECT_EQ(files(), (Texts{{"page.html", "new"}}));
}

TEST_F(SiteDirectoryTest, RefusesASecondBuilder) {
  {
    SiteDirectory first(site_);
    first.write("page.html", "first");
    EXPECT_EQ(refusal(), "another build is writing " + site_.string() + "; wait for it");
    first.commit();
  }
  EXPECT_EQ(files(), (Texts{{"page.html", "first"}}));
  EXPECT_EQ(refusal(), "");
}

TEST_F(SiteDirectoryTest, ReplacesTheSiteThatALinkLeadsTo) {
  const fs::path link = folder_.path() / "link";
  build("old");
  fs::create_symlink(site_, link);
  {
    SiteDirectory directory(link);
    directory.write("page.html", "new");
    directory.commit();
  }
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(files(), (Texts{{"page.html", "new"}}));
}

TEST_F(SiteDirectoryTest, DoesNotMindASlashAtTheEnd) {
  {
    SiteDirectory directory(site_ / "");
    directory.write("page.html", "new");
    directory.commit();
  }
  EXPECT_EQ(files(), (Texts{{"page.html", "new"}}));
}

TEST_F(SiteDirectoryTest, WritesWhatIsNotInMemoryAsAWhole) {
  SiteDirectory directory(site_);
  directory.write("deep/page.html", [](std::ostream& file) {
    file << "one"
         << "two";
  });
  directory.commit();
  EXPECT_EQ(files(), (Texts{{"deep/page.html", "onetwo"}}));
}

TEST_F(SiteDirectoryTest, CopiesOnceWhatIsCopiedTwice) {
  write_file(folder_.path() / "x", "x");
  SiteDirectory directory(site_, folder_.path());
  directory.copy(folder_.path() / "x", "y");
  directory.copy(folder_.path() / "x", "y");
  directory.commit();
  EXPECT_EQ(files(), (Texts{{"y", "x"}}));
}

TEST_F(SiteDirectoryTest, CopiesNothingFromOutsideOfTheCourse) {
  write_file(folder_.path() / "secret", "a secret");
  write_file(folder_.path() / "course" / "x", "x");
  fs::create_symlink("../secret", folder_.path() / "course" / "link");
  SiteDirectory directory(site_, folder_.path() / "course");
  EXPECT_THROW(directory.copy(folder_.path() / "course" / "link", "a"), std::runtime_error);
  EXPECT_THROW(directory.copy(folder_.path() / "secret", "b"), std::runtime_error);
  directory.copy(folder_.path() / "course" / "x", "c");
  directory.commit();
  EXPECT_EQ(files(), (Texts{{"c", "x"}}));
}

TEST_F(SiteDirectoryTest, DoesNotWriteThroughALinkInTheWay) {
  fs::create_directories(site_.parent_path());
  fs::create_directory(folder_.path() / "elsewhere");
  fs::create_symlink(folder_.path() / "elsewhere" / "lock", site_.parent_path() / ".site.lock");
  EXPECT_NE(refusal(), "");
  fs::remove(site_.parent_path() / ".site.lock");
  fs::create_symlink(folder_.path() / "elsewhere", site_.parent_path() / ".site.building");
  build("new");
  EXPECT_EQ(files(), (Texts{{"page.html", "new"}}));
  EXPECT_TRUE(fs::is_empty(folder_.path() / "elsewhere"));
}

// Whatever becomes of a course's names before they come here.
TEST_F(SiteDirectoryTest, WritesNothingOutsideOfItself) {
  const fs::path theirs = folder_.path() / "theirs";
  write_file(theirs, "as it was");
  fs::create_directories(site_.parent_path());
  fs::create_symlink(theirs, site_.parent_path() / "page.html");
  SiteDirectory directory(site_, folder_.path());
  const auto says = [](std::ostream& file) { file << "new"; };
  for (const std::string& path : {std::string("../page.html"), std::string("a/../../page.html"),
                                  std::string(".."), theirs.string()}) {
    EXPECT_THROW(directory.write(path, "new"), RefusedPath) << path;
    EXPECT_THROW(directory.write(path, says), RefusedPath) << path;
    EXPECT_THROW(directory.copy(theirs, path), RefusedPath) << path;
  }
  EXPECT_THROW(directory.copy_own(theirs, "own/../../page.html"), RefusedPath);
  // A line of the site's list each, which could be the name of a user's file.
  EXPECT_THROW(directory.write("a\nCNAME", "new"), std::runtime_error);
  directory.commit();
  EXPECT_EQ(files(), Texts{});
  EXPECT_EQ(read_file(theirs).value(), "as it was");
}

TEST_F(SiteDirectoryTest, LiesInACourseBehindNoLink) {
  const fs::path course = folder_.path() / "course", elsewhere = folder_.path() / "elsewhere";
  for (const fs::path& folder : {course, elsewhere}) fs::create_directory(folder);
  fs::create_symlink(elsewhere, course / "build");
  EXPECT_THROW(SiteDirectory(course / "build" / "site", course), RefusedPath);
  EXPECT_TRUE(fs::is_empty(elsewhere));
}

// What a user put into a site: a folder of git's, files at the top and beside ours, a link, and a
// folder in which there is nothing yet.
class ForeignFiles : public SiteDirectoryTest {
 protected:
  ForeignFiles() {
    {
      SiteDirectory directory(site_);
      directory.write("page.html", "old");
      directory.write("1-a/x.html", "old");
      directory.write("2-b/deep/y.html", "old");
      directory.commit();
    }
    for (const auto& [path, text] : own_) write_file(site_ / path, text);
    fs::create_symlink("/nowhere", site_ / "link");
    fs::create_directories(site_ / "2-b" / "empty");
  }
  // All that the user has in the site is there, beside a page that says `text`.
  void expect_all(const std::string& text) const {
    Texts expected = own_;
    expected["page.html"] = text;
    EXPECT_EQ(files(), expected);
    EXPECT_EQ(fs::read_symlink(site_ / "link"), "/nowhere");
    EXPECT_TRUE(fs::is_directory(site_ / "2-b" / "empty"));
    EXPECT_FALSE(fs::exists(site_ / "2-b" / "deep"));
    EXPECT_FALSE(fs::exists(staging_));
  }

  const Texts own_{{".git/HEAD", "ref"},
                   {".nojekyll", ""},
                   {"CNAME", "e.org"},
                   {"1-a/notes.txt", "notes"},
                   {"media/a/b", "b"}};
  const fs::path staging_ = site_.parent_path() / ".site.building";
};

TEST_F(ForeignFiles, StayWhereTheSiteIsReplaced) {
  build("new");
  expect_all("new");
  build("newer");
  expect_all("newer");
}

TEST_F(ForeignFiles, StayWhereTheNewSiteHasTheirFolder) {
  {
    SiteDirectory directory(site_);
    directory.write("page.html", "new");
    directory.write("media/a/c", "new");
    directory.commit();
  }
  fs::remove(site_ / "media" / "a" / "c");
  expect_all("new");
}

// As a kill leaves them that comes right behind the exchange.
TEST_F(ForeignFiles, ArePutBackByTheNextBuild) {
  fs::rename(site_, folder_.path() / "old");
  build("new");
  fs::rename(folder_.path() / "old", staging_);
  EXPECT_EQ(refusal(), "");
  expect_all("new");
}

TEST_F(ForeignFiles, ArePutBackWhereTheSiteIsGone) {
  fs::rename(site_, staging_);
  build("new");
  expect_all("new");
}

TEST_F(ForeignFiles, AreRefusedByNameWhereTheNewSiteNeedsTheirPlace) {
  const std::string cure = "; move yours elsewhere, or give it another name";
  const std::string stays = ", so it stays; but the new site has ";
  const std::string site = site_.string() + "/";
  EXPECT_EQ(refusal_of("CNAME"),
            "no build wrote " + site + "CNAME" + stays + "a file of that name" + cure);
  EXPECT_EQ(refusal_of(".git"),
            "no build wrote " + site + ".git" + stays + "a file of that name" + cure);
  EXPECT_EQ(refusal_of("CNAME/x"),
            "no build wrote " + site + "CNAME" + stays + "a folder of that name" + cure);
  EXPECT_EQ(refusal_of("1-a"),
            "no build wrote " + site + "1-a/notes.txt" + stays + "the file 1-a" + cure);
  Texts expected = own_;
  for (const char* page : {"page.html", "1-a/x.html", "2-b/deep/y.html"}) expected[page] = "old";
  EXPECT_EQ(files(), expected);
}

TEST_F(ForeignFiles, AreRefusedWhereAKilledBuildLeftOthersOfTheSameName) {
  fs::rename(site_, staging_);
  build("new");
  write_file(staging_ / kSiteList, std::string(kSiteList) + "\n");
  write_file(staging_ / "CNAME", "f.org");
  EXPECT_EQ(refusal(), "no build wrote " + staging_.string() +
                           "/CNAME, so it stays; but the new site has a file of that name; "
                           "move yours elsewhere, or give it another name");
  EXPECT_TRUE(fs::exists(staging_ / "CNAME"));
}

TEST_F(ForeignFiles, AreWhereTheyWereIfOneCannotBeMoved) {
  fs::create_directories(site_ / "other");  // no folder moves into itself
  EXPECT_THROW(move_foreign_files(OutFolder(site_), OutFolder(site_ / "other")), std::system_error);
  fs::remove_all(site_ / "other");  // empty folders
  build("new");
  expect_all("new");
}

// Of a hidden model, for one.
TEST_F(SiteDirectoryTest, ReplacesWhatABuildHasHiddenInAFolder) {
  for (const char* text : {"old", "new"}) {
    SiteDirectory directory(site_);
    directory.write("models/.old/arm.html", text);
    directory.commit();
    EXPECT_EQ(files(), (Texts{{"models/.old/arm.html", text}}));
  }
  build("newer");
  EXPECT_EQ(files(), (Texts{{"page.html", "newer"}}));
}

// Whatever a list says, which may be a stranger's.
TEST_F(ForeignFiles, AreWhatNoBuildWrites) {
  std::string list = read_file(site_ / kSiteList).value();
  for (const auto& [path, text] : own_) list += path + "\n";
  write_file(site_ / kSiteList, list);
  build("new");
  const Texts now = files();
  for (const char* path : {".git/HEAD", ".nojekyll", "CNAME", "media/a/b"}) {
    EXPECT_TRUE(now.contains(path)) << path;
  }
}

TEST_F(ForeignFiles, AreNamed) {
  EXPECT_EQ(foreign_files(site_),
            (std::vector<std::string>{".git", ".nojekyll", "1-a/notes.txt", "2-b/empty", "CNAME",
                                      "link", "media"}));
}

TEST_F(ForeignFiles, AreNotKnownOfASiteWithoutAList) {
  write_file(site_ / kSiteList, "");
  EXPECT_EQ(refusal(), site_.string() +
                           " was written by an earlier mjcourse, which kept no list of its "
                           "files; take what is yours out of it and remove it, or name an empty or "
                           "a new folder");
  EXPECT_TRUE(fs::exists(site_ / "CNAME"));
}

}  // namespace
}  // namespace mjcourse
