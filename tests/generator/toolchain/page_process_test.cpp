#include "toolchain/page_process.h"

#include <gtest/gtest.h>

#include "toolchain/scripted_page.h"

namespace mjcourse {
namespace {

class PageProcessTest : public testing::Test {
 protected:
  ScriptedPage page_{"42"};
  std::unique_ptr<PageToolchain> toolchain_ = PageToolchain::find(page_.folder());
  PageProcess process_{*toolchain_};
};

TEST_F(PageProcessTest, StaysForTheNextQuestion) {
  page_.runs("exec cat");  // whose answer is the question
  EXPECT_EQ(process_.ask("one", 10).value(), "one");
  page_.runs("exit 1");
  EXPECT_EQ(process_.ask("two", 10).value(), "two");
}

TEST_F(PageProcessTest, IsANewOneAfterOneThatEnded) {
  page_.runs("echo gone >&2; exit 3");
  const auto ended = process_.ask("one", 10);
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().code, 3);
  EXPECT_EQ(ended.error().err, "gone\n");
  page_.runs("sleep 60");
  EXPECT_EQ(process_.ask("two", 0.2).error().end, Outcome::End::timed_out);
  page_.runs("cat \"$2/answer\"; exec cat >/dev/null");
  EXPECT_EQ(process_.ask("three", 10).value(), "42");
}

TEST_F(PageProcessTest, ReadsNothingButItsOwn) {
  const TemporaryFolder other;
  write_file(other.path() / "secret", "a key");
  page_.runs("cat " + (other.path() / "secret").string());
  const auto ended = process_.ask("one", 10);
  ASSERT_FALSE(ended);
  EXPECT_NE(ended.error().err.find("Permission denied"), std::string::npos) << ended.error().err;
}

}  // namespace
}  // namespace mjcourse
