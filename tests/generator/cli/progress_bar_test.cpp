#include "cli/progress_bar.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "base/descriptor.h"
#include "report/pseudo_terminal.h"

namespace mjcourse {
namespace {

using namespace std::chrono_literals;

// What a terminal so wide is shown of the work, and at its end.
class ProgressBarTest : public testing::Test {
 protected:
  struct Shown {
    std::string first, end;
  };

  void SetUp() override {
    if (!PseudoTerminal::exists()) GTEST_SKIP() << "no pseudo terminals here";
  }

  static Shown shown(unsigned short columns, const std::function<void(ProgressBar&)>& work) {
    const PseudoTerminal terminal(columns);
    const Descriptor real(dup(STDERR_FILENO));
    dup2(terminal.descriptor(), STDERR_FILENO);
    Shown shown;
    {
      ProgressBar bar;
      work(bar);
      for (int i = 0; i < 1000 && !shown.first.ends_with("\033[K"); ++i) {
        std::this_thread::sleep_for(10ms);
        shown.first += terminal.written();
      }
    }
    shown.end = terminal.written();
    dup2(real.get(), STDERR_FILENO);
    shown.first = shown.first.substr(0, shown.first.find("\033[K"));
    return shown;
  }
};

TEST_F(ProgressBarTest, ShowsWhatIsDoneAndWhatIsBeingDone) {
  const Shown bar = shown(100, [](ProgressBar& progress) {
    progress.plan(4);
    progress.begin("draw a");
    progress.begin("run b");
    progress.begin("run c");
    progress.end("run b");
    progress.end("kept");
  });
  EXPECT_EQ(bar.first, "\r[============            ] 2/4  draw a, run c");
}

TEST_F(ProgressBarTest, IsWipedAtTheEnd) {
  const Shown bar = shown(100, [](ProgressBar& progress) { progress.plan(1); });
  EXPECT_TRUE(bar.end.ends_with("\r\033[K")) << bar.end;
}

TEST_F(ProgressBarTest, IsNotShownOfQuickWork) {
  const PseudoTerminal terminal(100);
  const Descriptor real(dup(STDERR_FILENO));
  dup2(terminal.descriptor(), STDERR_FILENO);
  { ProgressBar().plan(3); }
  dup2(real.get(), STDERR_FILENO);
  EXPECT_EQ(terminal.written(), "\r\033[K");
}

// Two columns for an ideograph, and no half of a letter.
TEST_F(ProgressBarTest, EndsWithTheLineOfTheTerminal) {
  const auto work = [](ProgressBar& progress) {
    progress.plan(1);
    progress.begin("日本é");
  };
  const std::string bar = "\r[                        ] 0/1  ";
  EXPECT_EQ(shown(38, work).first, bar + "日本é");
  EXPECT_EQ(shown(37, work).first, bar + "日本");
  EXPECT_EQ(shown(36, work).first, bar + "日");
  EXPECT_EQ(shown(35, work).first, bar + "日");
  EXPECT_EQ(shown(34, work).first, bar);
}

}  // namespace
}  // namespace mjcourse
