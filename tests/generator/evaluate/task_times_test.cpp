#include "evaluate/task_times.h"

#include <gtest/gtest.h>

#include "memory_store.h"
#include "reading_of.h"

namespace mjcourse {
namespace {

class TimedTask : public Task {
 public:
  explicit TimedTask(const Lesson& lesson) : Task(lesson, 0, 0, "work") {}
  double effort() const override { return 2; }
  Dependencies recipe(const RunContext&) const override { return {}; }
};

TEST(TaskTimes, AreThoseOfTheLastRun) {
  MemoryStore store;
  const ReadingOf reading = reading_of("");
  const TimedTask task(*reading.lesson);
  const Dependencies recipe{{"kind", "k"}, {"text", "as it was"}};
  const Dependencies other{{"kind", "k"}, {"text", "edited"}};
  TaskTimes times(&store, "a course");
  EXPECT_EQ(times.of(task, recipe).lasts, std::chrono::seconds(2));
  EXPECT_TRUE(times.of(task, recipe).is_edited);
  EXPECT_FALSE(times.of(task, {}).is_edited) << "what is done each time";
  times.note(task, recipe, 5);
  times.write();

  const TaskTimes read(&store, "a course");
  EXPECT_EQ(read.of(task, recipe).lasts, std::chrono::seconds(5));
  EXPECT_FALSE(read.of(task, recipe).is_edited);
  EXPECT_EQ(read.of(task, other).lasts, std::chrono::seconds(5));
  EXPECT_TRUE(read.of(task, other).is_edited);
  EXPECT_TRUE(TaskTimes(&store, "another").of(task, recipe).is_edited);
  EXPECT_TRUE(TaskTimes(nullptr, "a course").of(task, recipe).is_edited);
}

TEST(TaskTimes, AreWrittenWhereTheyDiffer) {
  MemoryStore store;
  const ReadingOf reading = reading_of("");
  const TimedTask task(*reading.lesson);
  const Dependencies recipe{{"kind", "k"}, {"text", "t"}};
  const auto noted = [&](double seconds) {
    TaskTimes times(&store, "a course");
    times.note(task, recipe, seconds);
    times.write();
    return TaskTimes(&store, "a course").of(task, recipe).lasts;
  };
  EXPECT_EQ(noted(5), std::chrono::seconds(5));
  EXPECT_EQ(noted(6), std::chrono::seconds(5)) << "about the same";
  EXPECT_EQ(noted(7), std::chrono::seconds(7));
}

TEST(TaskTimes, ForgetWhatTheCourseNoLongerHas) {
  MemoryStore store;
  const ReadingOf reading = reading_of("");
  const TimedTask task(*reading.lesson);
  const Dependencies recipe{{"kind", "k"}, {"text", "t"}};
  TaskTimes times(&store, "a course");
  times.note(task, recipe, 5);
  times.write();
  TaskTimes(&store, "a course").write();
  EXPECT_TRUE(TaskTimes(&store, "a course").of(task, recipe).is_edited);
}

}  // namespace
}  // namespace mjcourse
