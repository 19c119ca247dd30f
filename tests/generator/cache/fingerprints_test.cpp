#include "cache/fingerprints.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <thread>

#include "base/files.h"
#include "base/sha256.h"
#include "base/temporary_folder.h"
#include "cache/dependency.h"

namespace mjcourse {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::system_clock;

class FingerprintsTest : public testing::Test {
 protected:
  void write(const std::string& path, const std::string& bytes) const {
    write_file(folder_.path() / path, bytes);
  }

  TemporaryFolder folder_;
  Fingerprints prints_{folder_.path()};
};

TEST_F(FingerprintsTest, AreOfTheBytesAsTheyAre) {
  EXPECT_EQ(prints_.of("models/a.xml"), kAbsent);
  write("models/a.xml", "one");
  EXPECT_EQ(prints_.of("models/a.xml"), sha256("one"));
  write("models/a.xml", "two");  // of the same length, and within the same tick perhaps
  EXPECT_EQ(prints_.of("models/a.xml"), sha256("two"));
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(prints_.of("models/a.xml"), sha256("two"));
  write("models/a.xml", "six");
  EXPECT_EQ(prints_.of("models/a.xml"), sha256("six"));
}

TEST_F(FingerprintsTest, OfWhatIsNoFileAreOfNoBytes) {
  ASSERT_EQ(mkfifo((folder_.path() / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(prints_.of((folder_.path() / "pipe").string()), "unreadable");  // and not waited for
  EXPECT_EQ(prints_.of("/dev/zero"), "unreadable");
}

TEST_F(FingerprintsTest, OfAFolderAreOfItsNames) {
  write("models/a.xml", "one");
  const std::string before = prints_.of("models");
  write("models/a.xml", "two");
  EXPECT_EQ(prints_.of("models"), before);
  write("models/b.xml", "one");
  EXPECT_NE(prints_.of("models"), before);
}

TEST_F(FingerprintsTest, DoNotWaitForAPipe) {
  ASSERT_EQ(mkfifo((folder_.path() / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(prints_.of("pipe"), "unreadable");
}

TEST_F(FingerprintsTest, OfProgramsAreSaid) {
  EXPECT_EQ(prints_.of("program x"), kAbsent);
  prints_.set("program x", "1234");
  EXPECT_EQ(prints_.of("program x"), "1234");
  EXPECT_TRUE(prints_.unchanged_since("program x", Clock::now()));
}

// A result that was made while somebody saved a file is of neither version.
TEST_F(FingerprintsTest, KnowWhatHasChangedMeanwhile) {
  write("a", "one");
  write("folder/b", "one");
  std::this_thread::sleep_for(50ms);
  const Clock::time_point begin = Clock::now();
  EXPECT_TRUE(prints_.unchanged_since("a", begin));
  EXPECT_TRUE(prints_.unchanged_since("folder/c", begin));
  write("a", "one");
  EXPECT_FALSE(prints_.unchanged_since("a", begin));
  std::filesystem::remove(folder_.path() / "folder" / "b");
  EXPECT_FALSE(prints_.unchanged_since("folder/b", begin));
}

}  // namespace
}  // namespace mjcourse
