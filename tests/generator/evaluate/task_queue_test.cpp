#include "evaluate/task_queue.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

class Work : public Task {
 public:
  Work(const Lesson& lesson, std::size_t block, double effort, bool quotes = false)
      : Task(lesson, 0, block, "work"), effort_(effort), quotes_(quotes) {}
  bool quotes() const override { return quotes_; }
  double effort() const override { return effort_; }
  Dependencies recipe(const Setting&) const override { return {}; }
  bool work(Workshop&, Finding&) override { return true; }

 private:
  double effort_;
  bool quotes_;
};

class TaskQueueTest : public testing::Test {
 protected:
  void add(double effort, bool quotes = false) {
    tasks_.push_back(std::make_unique<Work>(*reading_.lesson, tasks_.size(), effort, quotes));
  }
  std::vector<std::size_t> order(const Blocks& first = {}) {
    TaskQueue queue(tasks_, first, [] {});
    std::vector<std::size_t> order;
    while (const auto next = queue.next()) order.push_back(*next);
    return order;
  }

  ReadingOf reading_ = reading_of("");
  Tasks tasks_;
};

TEST_F(TaskQueueTest, BeginsWithTheMostEffort) {
  for (const double effort : {1, 4, 2, 3}) add(effort);
  EXPECT_EQ(order(), (std::vector<std::size_t>{1, 3, 2, 0}));
}

TEST_F(TaskQueueTest, BeginsWithWhatSomebodyWaitsFor) {
  for (const double effort : {1, 3, 2}) add(effort);
  EXPECT_EQ(order({{reading_.lesson->source->path(), 2}, {"another", 0}}),
            (std::vector<std::size_t>{2, 1, 0}));
}

TEST_F(TaskQueueTest, PutsWhatQuotesBehindTheRest) {
  add(5, true);
  add(1);
  EXPECT_EQ(order(), (std::vector<std::size_t>{1, 0}));
}

}  // namespace
}  // namespace mjcourse
