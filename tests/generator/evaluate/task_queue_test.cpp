#include "evaluate/task_queue.h"

#include <gtest/gtest.h>

#include <thread>

#include "reading_of.h"

namespace mjcourse {
namespace {

enum class Kind { plain, quoting, drawing, compiling };

class Work : public Task {
 public:
  Work(const Lesson& lesson, std::size_t block, double effort, Kind kind)
      : Task(lesson, 0, block, "work"), effort_(effort), kind_(kind) {}
  std::vector<std::string> quoted() const override {
    return kind_ == Kind::quoting ? std::vector<std::string>{"example"}
                                  : std::vector<std::string>{};
  }
  bool draws() const override { return kind_ == Kind::drawing; }
  bool compiles() const override { return kind_ == Kind::compiling; }
  double effort() const override { return effort_; }
  Dependencies recipe(const RunContext&) const override { return {}; }
  bool work(WorkerContext&, Finding&) override { return true; }

 private:
  double effort_;
  Kind kind_;
};

class TaskQueueTest : public testing::Test {
 protected:
  void add(double effort, Kind kind = Kind::plain) {
    tasks_.push_back(std::make_unique<Work>(*reading_.lesson, tasks_.size(), effort, kind));
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
  add(5, Kind::quoting);
  add(1);
  EXPECT_EQ(order(), (std::vector<std::size_t>{1, 0}));
}

TEST_F(TaskQueueTest, LetsOneThreadDrawAsLongAsThereIsAnythingElse) {
  for (const double effort : {1, 3, 2}) add(effort, Kind::drawing);
  for (const double effort : {4, 5}) add(effort);
  TaskQueue queue(tasks_, {}, [] {});
  EXPECT_EQ(queue.next(1), 1);  // the longest that draws
  EXPECT_EQ(queue.next(0), 4);
  queue.finish(1);
  EXPECT_EQ(queue.next(0), 3);  // the other one draws
  EXPECT_EQ(queue.next(1), 2);
  EXPECT_EQ(queue.next(0), 0);  // a thread with nothing else to do draws as well
  EXPECT_EQ(queue.next(0), std::nullopt);
}

TEST_F(TaskQueueTest, DrawsLaterWhatNobodyWaitsFor) {
  add(1);
  add(5, Kind::drawing);
  add(2);
  EXPECT_EQ(order({{reading_.lesson->source->path(), 0}}), (std::vector<std::size_t>{0, 1, 2}));
}

TEST_F(TaskQueueTest, DrawsFirstWhatSomebodyWaitsFor) {
  add(5);
  add(1, Kind::drawing);
  add(2, Kind::drawing);
  EXPECT_EQ(order({{reading_.lesson->source->path(), 1}}), (std::vector<std::size_t>{1, 2, 0}));
}

TEST_F(TaskQueueTest, CompilesLastUntilHeadersAreMade) {
  for (const double effort : {5, 4}) add(effort, Kind::compiling);
  for (const double effort : {1, 2, 3}) add(effort);
  TaskQueue queue(tasks_, {}, [] {});
  EXPECT_EQ(queue.next(), 4);
  queue.programs_known();
  EXPECT_EQ(queue.next(), 3);
  queue.headers_made();
  EXPECT_EQ(queue.next(), 0);
  EXPECT_EQ(queue.next(), 1);
  EXPECT_EQ(queue.next(), 2);
}

TEST_F(TaskQueueTest, CompilesWithoutAHeaderWhereNothingElseIsToBeDone) {
  add(1, Kind::compiling);
  TaskQueue queue(tasks_, {}, [] {});
  queue.programs_known();
  EXPECT_EQ(queue.next(), 0);
}

TEST_F(TaskQueueTest, WaitsUntilProgramsAreKnown) {
  add(1, Kind::compiling);
  TaskQueue queue(tasks_, {}, [] {});
  std::optional<std::size_t> next;
  {
    const std::jthread waits([&] { next = queue.next(); });
    queue.programs_known();
  }
  EXPECT_EQ(next, 0);
}

TEST_F(TaskQueueTest, LetsThoseGoThatWaitWhereSomethingWentWrong) {
  add(1, Kind::compiling);
  TaskQueue queue(tasks_, {}, [] {});
  std::optional<std::size_t> next = 5;
  {
    const std::jthread waits([&] { next = queue.next(); });
    queue.stop();
  }
  EXPECT_EQ(next, std::nullopt);
}

}  // namespace
}  // namespace mjcourse
