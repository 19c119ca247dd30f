#include "cli/settled_grades.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>

namespace mjcourse {
namespace {

Grade slow() {
  Grade grade;
  grade.faults = {{{"id", "E-example-timeout"}, {"message", "it still ran after 10 s"}}};
  return grade;
}

// Text 1 is slow while others are judged, text 3 always.
class SettledGradesTest : public testing::Test {
 protected:
  std::vector<Grade> settle(std::size_t count) {
    GradeWork work;
    work.judge = [this](std::size_t i) {
      const int together = ++running_;
      const std::lock_guard lock(mutex_);
      if (++judged_[i] > 1) most_again_ = std::max(most_again_, together);
      --running_;
      return i == 3 || (i == 1 && judged_[i] == 1) ? slow() : Grade();
    };
    work.done = [this](std::size_t i, const Grade&) {
      const std::lock_guard lock(mutex_);
      ++done_[i];
    };
    work.again = [this](std::size_t texts) { again_.push_back(texts); };
    return settled_grades(count, 4, work);
  }

  std::mutex mutex_;
  std::atomic<int> running_ = 0;
  int most_again_ = 0;
  std::map<std::size_t, int> judged_, done_;
  std::vector<std::size_t> again_;
};

TEST_F(SettledGradesTest, AreThoseOfASecondTryWhereOthersMayHaveEndedTheFirst) {
  const std::vector<Grade> grades = settle(40);
  EXPECT_EQ(again_, std::vector<std::size_t>{2});
  EXPECT_EQ(most_again_, 1);
  for (std::size_t i = 0; i < grades.size(); ++i) {
    EXPECT_EQ(grades[i].may_be_of_others(), i == 3) << i;
    EXPECT_EQ(judged_[i], i == 1 || i == 3 ? 2 : 1) << i;
    EXPECT_EQ(done_[i], 1) << i;
  }
}

TEST_F(SettledGradesTest, NeedNoSecondTryWhereTheFirstWasTheTextsOwn) {
  EXPECT_EQ(settle(1).size(), 1u);
  EXPECT_TRUE(again_.empty());
}

}  // namespace
}  // namespace mjcourse
