#include "base/last_use.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

constexpr std::time_t kHour = 3600;

struct stat used_at(std::time_t seconds) {
  struct stat file {};
  file.st_mtim.tv_sec = seconds;
  return file;
}

TEST(LastUse, IsTheTimeOfTheFile) {
  const std::time_t now = std::time(nullptr);
  EXPECT_EQ(LastUse::of(used_at(17)), (LastUse{17, 0}));
  EXPECT_LT(LastUse::of(used_at(17)), LastUse::of(used_at(now)));
  EXPECT_LT(LastUse::of(used_at(now)), LastUse::of(used_at(now + kHour / 2)));  // another's clock
}

TEST(LastUse, IsNeverWhereItIsToCome) {
  const std::time_t now = std::time(nullptr);
  for (const std::time_t time :
       {now + 24 * kHour, std::time_t{1} << 40, std::numeric_limits<std::time_t>::max()}) {
    EXPECT_EQ(LastUse::of(used_at(time)), LastUse()) << time;
    EXPECT_LT(LastUse::of(used_at(time)), LastUse::of(used_at(-1))) << time;
  }
}

TEST(LastUse, IsToldOnceAnHour) {
  const std::time_t now = std::time(nullptr);
  EXPECT_FALSE(is_use_outdated(used_at(now)));
  EXPECT_FALSE(is_use_outdated(used_at(now - kHour / 2)));
  for (const std::time_t time :
       {now - 2 * kHour, now + 24 * kHour, std::numeric_limits<std::time_t>::min(),
        std::numeric_limits<std::time_t>::max()}) {
    EXPECT_TRUE(is_use_outdated(used_at(time))) << time;
  }
}

}  // namespace
}  // namespace mjcourse
