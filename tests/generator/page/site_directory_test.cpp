#include "page/site_directory.h"

#include <gtest/gtest.h>

#include <map>
#include <ostream>

#include "base/files.h"
#include "base/temporary_folder.h"

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

  // The site's files without the mark that tells it from other folders.
  Texts files() const {
    Texts texts;
    for (const auto& entry : fs::recursive_directory_iterator(site_)) {
      const std::string path = fs::relative(entry.path(), site_);
      if (entry.is_regular_file() && path[0] != '.') {
        texts[path] = DiskFiles(site_).read(path).value();
      }
    }
    return texts;
  }

  // What opening the site's folder throws.
  std::string refusal() const {
    try {
      const SiteDirectory directory(site_);
    } catch (const std::runtime_error& error) {
      return error.what();
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
                           " holds something that no build made; it would be replaced. "
                           "Name an empty or a new folder.");
  EXPECT_EQ(files(), (Texts{{"precious.txt", "work of years"}}));
}

TEST_F(SiteDirectoryTest, RefusesAFile) {
  write_file(site_, "a file");
  EXPECT_NE(refusal(), "");
  EXPECT_TRUE(fs::is_regular_file(site_));
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

}  // namespace
}  // namespace mjcourse
