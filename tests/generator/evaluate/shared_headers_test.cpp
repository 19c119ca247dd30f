#include "evaluate/shared_headers.h"

#include <gtest/gtest.h>

#include "base/temporary_folder.h"
#include "course/course_of.h"
#include "evaluate/context/run_context.h"

namespace mjcourse {
namespace {

class ProgramOf : public Task {
 public:
  ProgramOf(const Lesson& lesson, std::vector<std::string> roots)
      : Task(lesson, 0, 0, "compile"), roots_(std::move(roots)) {}
  std::vector<std::string> warm_roots(const RunContext&) const override { return roots_; }
  Dependencies recipe(const RunContext&) const override { return {}; }
  bool work(WorkerContext&, Finding&) override { return true; }

 private:
  std::vector<std::string> roots_;
};

class SharedHeadersTest : public testing::Test {
 protected:
  // What is worth making for so many programs with these roots.
  std::vector<SharedHeader> headers_for(
      const std::map<std::vector<std::string>, std::size_t>& programs) {
    std::vector<std::unique_ptr<Task>> tasks;
    std::vector<const Task*> waiting;
    for (const auto& [roots, count] : programs) {
      for (std::size_t i = 0; i < count; ++i) {
        tasks.push_back(std::make_unique<ProgramOf>(course_.course->lessons[0], roots));
        waiting.push_back(tasks.back().get());
      }
    }
    return shared_headers(run_context_, waiting);
  }

  TemporaryFolder folder_;
  CourseOf course_ = course_of("", "");
  const DiskFiles assets_{MJCOURSE_ASSETS};
  RunContext run_context_{
      *course_.course, folder_.path(), assets_, {}, folder_.path() / "prepared"};
};

TEST_F(SharedHeadersTest, AreOfNoUseToOneProgram) {
  EXPECT_TRUE(headers_for({{{}, 5}, {{"mujoco/mujoco.h"}, 1}, {{"vector"}, 1}}).empty());
}

TEST_F(SharedHeadersTest, ServeSeveral) {
  const auto headers = headers_for({{{"mujoco/mujoco.h"}, 2}, {{"vector"}, 1}});
  ASSERT_EQ(headers.size(), 1);
  EXPECT_EQ(headers[0].roots, std::vector<std::string>{"mujoco/mujoco.h"});
  EXPECT_EQ(headers[0].warmth, Warmth::quick);
  EXPECT_EQ(headers[0].what(), "compile once what 2 programs include");
}

TEST_F(SharedHeadersTest, AreThoroughForMany) {
  EXPECT_EQ(headers_for({{{"vector"}, 39}}).at(0).warmth, Warmth::quick);
  EXPECT_EQ(headers_for({{{"vector"}, 40}}).at(0).warmth, Warmth::thorough);
}

TEST_F(SharedHeadersTest, AreNotMadeWhereTheyCannotBeKept) {
  const RunContext run_context(*course_.course, folder_.path(), assets_);
  const ProgramOf program(course_.course->lessons[0], {"vector"});
  EXPECT_TRUE(shared_headers(run_context, {&program, &program}).empty());
}

TEST_F(SharedHeadersTest, AreMadeOnce) {
  run_context_.compiler()->make_header({"vector"}, Warmth::quick);
  EXPECT_TRUE(headers_for({{{"vector"}, 100}}).empty());
}

}  // namespace
}  // namespace mjcourse
