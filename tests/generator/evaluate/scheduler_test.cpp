#include "evaluate/scheduler.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "evaluate/evaluation_of.h"
#include "evaluate/page_task.h"
#include "evaluate/program_task.h"

namespace mjcourse {
namespace {

enum class When { never, preparing, working };

class Faulty : public Task {
 public:
  Faulty(const Lesson& lesson, std::size_t block, When when, bool compiled)
      : Task(lesson, 0, block, "work"), when_(when), compiled_(compiled) {}
  bool compiles() const override { return compiled_; }
  Dependencies recipe(const RunContext&) const override { return {}; }
  bool prepare(WorkerContext&, Finding&) override {
    if (when_ == When::preparing) throw std::logic_error("not foreseen\nat all");
    return true;
  }
  bool work(WorkerContext& worker_context, Finding& finding) override {
    worker_context.typesetter();  // what a former task left of the worker context is of use
    if (when_ == When::working) throw std::out_of_range("not foreseen");
    finding.results[block()] = ValueResult{"done", ""};
    return true;
  }

 private:
  When when_;
  bool compiled_;
};

// What throws is told at its block, and everything else is done.
TEST(Scheduler, GoesOnBehindAFault) {
  const DiskFiles assets(MJCOURSE_ASSETS);
  const TemporaryFolder folder;
  ReadingOf reading = reading_of("A $a$.\n\nAnd $b$.\n");
  Course course;
  course.lessons.push_back(std::move(*reading.lesson));
  const Lesson& lesson = course.lessons[0];
  for (const bool compiled : {false, true}) {
    Tasks tasks;
    const auto add = [&](std::size_t block, When when) {
      tasks.push_back(std::make_unique<Faulty>(lesson, block, when, compiled));
    };
    add(0, When::preparing);
    add(1, When::working);
    for (int i = 0; i < 6; ++i) add(1, When::never);
    const RunContext run_context(course, folder.path(), assets, {}, std::nullopt,
                                 std::make_shared<ScriptBundles>());
    NoProgress progress;
    Scheduler scheduler(run_context, nullptr, progress, 2);
    const TaskRecords records = scheduler.run(tasks, {}, [](const TaskRecords&) {});
    const std::string cure =
        "  cure: is there enough memory and disk space? If so, report it with this block; "
        "everything "
        "else was checked\n";
    EXPECT_EQ(shown(records[0].finding.diagnostics),
              "content/1-a/1.1-x.md:4:4: error: mjcourse itself failed at this: not foreseen\\nat "
              "all [E-internal]\n"
              "  4 | A $a$.\n    |    ^\n" +
                  cure);
    EXPECT_EQ(shown(records[1].finding.diagnostics),
              "content/1-a/1.1-x.md:6:6: error: mjcourse itself failed at this: not foreseen "
              "[E-internal]\n"
              "  6 | And $b$.\n    |      ^\n" +
                  cure);
    for (std::size_t i = 2; i < records.size(); ++i) {
      EXPECT_EQ(records[i].finding.results.size(), 1u);
    }
  }
}

// The page's half of a program, which says what it is told of the native one.
class Told : public Task {
 public:
  Told(const Lesson& lesson, std::size_t block, const std::string& what, std::string& told)
      : Task(lesson, 0, block, what), told_(told) {}
  Dependencies recipe(const RunContext&) const override { return {}; }
  bool work_in_page(WorkerContext&, const Finding* native, Finding&) override {
    told_ =
        native == nullptr ? "nothing" : std::get<ExampleResult>(native->results.at(block())).output;
    return true;
  }

 private:
  std::string& told_;
};

TEST(Scheduler, TellsThePageWhatWasFoundOfAProgram) {
  const DiskFiles assets(MJCOURSE_ASSETS);
  const TemporaryFolder folder;
  const std::string right = "#include <cstdio>\nint main() { std::puts(\"right\"); }\n";
  const std::string wrong = "int main() { return none; }\n";
  write_file(folder.path() / "examples/right.cpp", right);
  write_file(folder.path() / "examples/wrong.cpp", wrong);
  ReadingOf reading = reading_of("```cpp file=examples/right.cpp\n" + right +
                                 "```\n\n```cpp file=examples/wrong.cpp\n" + wrong + "```\n");
  Course course;
  course.lessons.push_back(std::move(*reading.lesson));
  const Lesson& lesson = course.lessons[0];
  const RunContext run_context(course, folder.path(), assets, {}, std::nullopt,
                               std::make_shared<ScriptBundles>());
  if (!run_context.compiler()) GTEST_SKIP() << "no compiler is installed";
  std::string of_right = "not asked", of_wrong = "not asked", alone = "not asked";
  Tasks tasks;
  const auto add_page = [&](std::size_t block, const std::string& what, std::string& told) {
    tasks.push_back(std::make_unique<PageTask>(std::make_unique<Told>(lesson, block, what, told)));
  };
  add_page(0, "compile and run right", of_right);
  for (const std::size_t block : {1u, 0u}) {
    const auto& program = std::get<Example>(lesson.blocks[block]);
    tasks.push_back(std::make_unique<ProgramTask>(lesson, 0, block, program));
  }
  add_page(1, "compile and run wrong", of_wrong);
  add_page(0, "what another machine runs", alone);
  NoProgress progress;
  Scheduler scheduler(run_context, nullptr, progress, 2);
  scheduler.run(tasks, {}, [](const TaskRecords&) {});
  EXPECT_EQ(of_right, "right\n");
  EXPECT_EQ(of_wrong, "not asked");  // what fails natively is not compiled for the page
  EXPECT_EQ(alone, "nothing");
}

}  // namespace
}  // namespace mjcourse
