#include "session/folder_watch.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>
#include <functional>
#include <optional>
#include <thread>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Paths = std::set<fs::path>;

class FolderWatchTest : public testing::Test {
 protected:
  FolderWatchTest() {
    write_file(root_ / "content/one.md", "one");
    write_file(root_ / "content/deep/two.md", "two");
    watch_.emplace(std::vector<fs::path>{root_ / "content", root_ / "models"});
  }

  // What one change of the files is told as, below the root; nothing where nothing is told.
  Paths told(const std::function<void()>& change) {
    change();
    std::stop_source stop;
    const std::jthread impatient([&](const std::stop_token& done) {
      for (int i = 0; i < 100 && !done.stop_requested(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      stop.request_stop();
    });
    Paths below;
    for (const fs::path& path : watch_->wait(stop.get_token())) {
      below.insert(path.lexically_relative(root_));
    }
    return below;
  }

  const TemporaryFolder folder_;
  const fs::path root_ = folder_.path() / "course";
  std::optional<FolderWatch> watch_;
};

TEST_F(FolderWatchTest, TellsAFileThatIsWritten) {
  EXPECT_EQ(told([&] { write_file(root_ / "content/one.md", "1"); }), Paths{"content/one.md"});
  EXPECT_EQ(told([&] { write_file(root_ / "content/deep/two.md", "2"); }),
            Paths{"content/deep/two.md"});
}

TEST_F(FolderWatchTest, TellsWhatALinkLeadsToUnderTheLinksName) {
  write_file(root_ / "real/three.md", "three");
  write_file(root_ / "shared/four.md", "four");
  write_file(folder_.path() / "elsewhere/five.md", "five");
  fs::create_symlink("../real", root_ / "content/folder");
  fs::create_symlink("../shared/four.md", root_ / "content/four.md");
  fs::create_symlink("../../elsewhere", root_ / "content/out");
  watch_.emplace(std::vector<fs::path>{root_ / "content", root_ / "models"});
  EXPECT_EQ(told([&] { write_file(root_ / "real/three.md", "3"); }),
            (Paths{"content/folder/three.md", "real/three.md"}));
  EXPECT_EQ(told([&] { write_file(root_ / "shared/four.md", "4"); }),
            (Paths{"content/four.md", "shared/four.md"}));
  EXPECT_EQ(told([&] { write_file(folder_.path() / "elsewhere/five.md", "5"); }), Paths{});
}

TEST_F(FolderWatchTest, TellsWhatALinkLeadsToThatCameLater) {
  write_file(root_ / "real/three.md", "three");
  told([&] { fs::create_symlink("../real", root_ / "content/folder"); });
  EXPECT_EQ(told([&] { write_file(root_ / "real/three.md", "3"); }),
            (Paths{"content/folder/three.md", "real/three.md"}));
}

TEST_F(FolderWatchTest, TellsAllOfOneSaveAtOnce) {
  // As vim does it.
  const fs::path file = root_ / "content/one.md";
  EXPECT_EQ(told([&] {
              fs::rename(file, file.string() + ".moved");
              write_file(file, "1");
              fs::remove(file.string() + ".moved");
            }),
            (Paths{"content/one.md", "content/one.md.moved"}));
  EXPECT_EQ(told([] {}), Paths{});
}

TEST_F(FolderWatchTest, TellsManyFilesAtOnce) {
  const Paths all = told([&] {
    for (int i = 0; i < 200; ++i) {
      write_file(root_ / "content" / (std::to_string(i) + ".md"), "text");
    }
  });
  EXPECT_EQ(all.size(), 200);
}

TEST_F(FolderWatchTest, FollowsFoldersThatComeAndGo) {
  EXPECT_TRUE(
      told([&] { write_file(root_ / "models/parts/a.xml", "<mujoco/>"); }).contains("models"));
  EXPECT_EQ(told([&] { write_file(root_ / "models/parts/a.xml", "other"); }),
            Paths{"models/parts/a.xml"});
  EXPECT_TRUE(told([&] {
                fs::rename(root_ / "content/deep", root_ / "content/high");
              }).contains("content/high"));
  EXPECT_EQ(told([&] { write_file(root_ / "content/high/two.md", "2"); }),
            Paths{"content/high/two.md"});
  EXPECT_TRUE(told([&] { fs::remove_all(root_ / "content"); }).contains("content"));
  EXPECT_TRUE(told([&] { write_file(root_ / "content/one.md", "again"); }).contains("content"));
  EXPECT_EQ(told([&] { write_file(root_ / "content/one.md", "1"); }), Paths{"content/one.md"});
}

TEST_F(FolderWatchTest, PassesOverWhatEditorsKeepForThemselves) {
  EXPECT_EQ(told([&] {
              write_file(root_ / "content/.one.md.swp", "");
              write_file(root_ / "content/one.md~", "");
              write_file(root_ / "other/file", "");
            }),
            Paths{});
}

TEST_F(FolderWatchTest, ForgetsWhatWasMovedAway) {
  EXPECT_TRUE(told([&] {
                fs::rename(root_ / "content/deep", folder_.path() / "deep");
              }).contains("content/deep"));
  EXPECT_EQ(told([&] { write_file(folder_.path() / "deep/two.md", "2"); }), Paths{});
}

TEST(FolderWatchRoom, SaysWhatHelpsWhereNothingMoreCanBeWatched) {
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  const rlimit none{0, before.rlim_max};  // fails as when a user has too many instances
  setrlimit(RLIMIT_NOFILE, &none);
  std::string said;
  try {
    const FolderWatch watch({"/tmp"});
  } catch (const std::system_error& error) {
    said = error.what();
  }
  setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_EQ(said,
            "too many programs watch folders; end one, or raise fs.inotify.max_user_instances: "
            "Too many open files");
}

}  // namespace
}  // namespace mjcourse
