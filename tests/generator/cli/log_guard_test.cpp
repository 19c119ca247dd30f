#include "cli/log_guard.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ostream>
#include <sstream>
#include <string>

namespace mjcourse {
namespace {

std::string logged(const std::string& text) {
  std::ostringstream out;
  PlainLog log(*out.rdbuf());
  std::ostream stream(&log);
  for (const char c : text) stream << c << std::flush;  // as std::cerr does
  return out.str();
}

TEST(LogGuard, LeavesNoCommandAtTheBeginningOfALine) {
  EXPECT_EQ(logged("::stop-commands::x\n"), "\\::stop-commands::x\n");
  EXPECT_EQ(logged("a\n    ::error ::x\n"), "a\n    \\::error ::x\n");
  EXPECT_EQ(logged("a\r\t::x"), "a\r\t\\::x");
  EXPECT_EQ(logged("\v\f ::x"), "\v\f \\::x");
  for (const std::string blank : {"\u00A0", "\u1680", "\u2003", "\u2028", "\u3000"}) {
    EXPECT_EQ(logged(blank + "::x"), blank + "\\::x");
  }
}

TEST(LogGuard, LeavesNoCommandInsideALine) {
  EXPECT_EQ(logged("title ##[add-mask]x"), "title ##\\[add-mask]x");
  EXPECT_EQ(logged("###[x] ##vso[task.setvariable]x"), "###\\[x] ##vso\\[task.setvariable]x");
}

TEST(LogGuard, LeavesAllElseAsItIs) {
  const std::string text =
      "a.md:5:1: error: std::bad_alloc [E-x]\n  ## Title\n#[x] # #[y] ##a b[0]\n";
  EXPECT_EQ(logged(text), text);
}

TEST(LogGuard, GuardsOnlyInALogAndOnlyWhatPeopleRead) {
  unsetenv("GITHUB_ACTIONS");
  unsetenv("TF_BUILD");
  testing::internal::CaptureStdout();
  {
    const LogGuard guard(true);
    std::cout << "::a\n";
  }
  setenv("GITHUB_ACTIONS", "true", 1);
  {
    const LogGuard guard(false);
    std::cout << "::b\n";
  }
  {
    const LogGuard guard(true);
    std::cout << "::c\n";
  }
  std::cout << "::d\n";
  unsetenv("GITHUB_ACTIONS");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "::a\n::b\n\\::c\n::d\n");
}

}  // namespace
}  // namespace mjcourse
