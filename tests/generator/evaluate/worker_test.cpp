#include "evaluate/worker.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "evaluate/evaluation_of.h"
#include "evaluate/plan.h"
#include "lesson/read_lesson.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLesson = "---\ntitle: T\n---\nIt has `{ball} model.nv` of them.\n";

// A course whose only value a worker is asked for that was taken over.
class WorkerTest : public testing::Test {
 protected:
  WorkerTest() {
    write("models/ball.xml", kBall);
    write(".git/config", "a token");
    write("content/1-a/1.1-x.md", kLesson);
    write_file(home_.path() / "secret", "a key");
    Diagnostics none;
    course_.models = {"ball"};
    course_.add(read_lesson("content/1-a/1.1-x.md", kLesson, none).value());
    tasks_ = plan_tasks(course_);
  }

  void write(const std::string& path, const std::string& text) const {
    write_file(folder_.path() / path, text);
  }

  // What is found where the worker does the `deed` (hostile_worker.cpp), or what is thrown.
  std::string found(const std::string& deed, WorkLimits limits = {}) {
    write("models/deed.txt", deed);
    return found_by(MJCOURSE_HOSTILE_WORKER, limits);
  }

  std::string found_by(const fs::path& program, WorkLimits limits = {}) {
    const DiskFiles assets(MJCOURSE_ASSETS);
    const RunContext run_context(course_, folder_.path(), assets);
    Worker worker(run_context, {program, MJCOURSE_ASSETS}, limits);
    return found_by(worker);
  }

  std::string found_by(Worker& worker) {
    trace_.clear();
    finding_ = {};
    try {
      whole_ = worker.work(*tasks_.at(0), trace_, finding_);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return shown(finding_.diagnostics);
  }

  static std::string at_block(const std::string& message, const std::string& cure = "") {
    return "content/1-a/1.1-x.md:4:10: error: " + message +
           "\n  4 | It has `{ball} model.nv` of them.\n    |          ^~~~\n" +
           (cure.empty() ? "" : "  cure: " + cure + "\n");
  }

  TemporaryFolder folder_, home_;
  Course course_;
  Tasks tasks_;
  Trace trace_{folder_.path()};
  Finding finding_;
  bool whole_ = false;
};

TEST_F(WorkerTest, ReachesNothingThatItNeedsNot) {
  setenv("MJCOURSE_TEST_SECRET", "a token", 1);
  const std::string said = found("reach " + (home_.path() / "secret").string());
  unsetenv("MJCOURSE_TEST_SECRET");
  EXPECT_EQ(said,
            "reads a model: yes, reads a secret: no, reads the repository: no, writes a lesson: "
            "no, has a secret in its environment: no, connects: no, signals the generator: no");
}

TEST_F(WorkerTest, WorksAsTheTaskWouldHere) {
  EXPECT_EQ(found_by(MJCOURSE_PROGRAM), "");
  EXPECT_TRUE(whole_);
  EXPECT_EQ(std::get<ValueResult>(finding_.results.at(tasks_.at(0)->block())).text, "7");
  EXPECT_EQ(trace_.names(), std::set<std::string>({"models/ball.xml", "program ball"}));
  EXPECT_TRUE(trace_.complete());
}

TEST_F(WorkerTest, IsBegunAnewBehindItsEnd) {
  const DiskFiles assets(MJCOURSE_ASSETS);
  const RunContext run_context(course_, folder_.path(), assets);
  write("models/deed.txt", "leave");
  Worker worker(run_context, {MJCOURSE_HOSTILE_WORKER, MJCOURSE_ASSETS});
  EXPECT_NE(found_by(worker), "");
  write("models/deed.txt", "say {\"failure\": \"it is back\"}");
  EXPECT_EQ(found_by(worker), "it is back");
}

TEST_F(WorkerTest, TellsOfItsEndAtTheBlock) {
  EXPECT_EQ(found("crash"),
            at_block("the process that works on this ended with SIGSEGV [E-work-crash]",
                     "MuJoCo or the script engine crashed: look for indices and sizes that do not "
                     "fit the model"));
  EXPECT_FALSE(whole_);
  EXPECT_FALSE(trace_.complete());
  EXPECT_EQ(found("leave"),
            at_block("the process that works on this ended without an answer: it had enough "
                     "[E-work-crash]"));
}

TEST_F(WorkerTest, HasItsLimits) {
  EXPECT_EQ(
      found("hang", {1, 1 << 30}),
      at_block("this takes more than 1 s to work out [E-work-time]",
               "make it smaller: fewer controls or questions, shorter runs, a smaller model"));
  EXPECT_EQ(found("grow", {30, 512 << 20}),
            at_block("this takes more than 512 MiB of memory [E-work-memory]",
                     "look for a list that grows in a script, or a large number in a model; with "
                     "fewer workers, each has more of this machine's memory: `--jobs 1`"));
  EXPECT_EQ(found("promise", {30, 512 << 20}),
            at_block("the process that works on this ended without an answer [E-work-crash]"));
}

// Of what it says, nothing is taken on trust.
TEST_F(WorkerTest, IsHeldAgainstItsQuestion) {
  const std::string no_answer = "the process that works on this gave no answer to it";
  EXPECT_EQ(found("babble"), no_answer);
  EXPECT_EQ(found("nest"), no_answer);
  const std::string block = std::to_string(tasks_.at(0)->block());
  const auto finding = [](const std::string& text) { return "say {\"finding\": {" + text + "}}"; };
  EXPECT_EQ(
      found(finding("\"results\": [[" + block + ", [1, {\"text\": \"8\", \"origin\": \"\"}]]]")),
      "");
  EXPECT_EQ(found(finding("\"results\": [[99, [1, {\"text\": \"8\", \"origin\": \"\"}]]]")),
            no_answer);
  EXPECT_EQ(found(finding("\"results\": [[" + block + ", [0, {\"markup\": \"<script>\"}]]]")),
            no_answer);
  for (const std::string path : {"/etc/shadow", "/usr/../etc/shadow", "../x", "models/../../x"}) {
    EXPECT_EQ(found("say {\"looked_at\": [\"" + path + "\"]}"), no_answer) << path;
  }
  for (const std::string path :
       {".git/hooks/pre-commit", "content/1-a/1.1-x.md", "content/../x.png"}) {
    EXPECT_EQ(found(finding(
                  "\"diagnostics\": [{\"id\": \"E-x\", \"severity\": 0, \"message\": \"\", "
                  "\"detail\": \"\", \"notes\": [], \"cure\": \"\", \"place\": {\"file\": "
                  "\"\", \"line\": 0, \"column\": 0, \"width\": 1, \"excerpt\": \"\", "
                  "\"excerpt_column\": 1}, \"edit\": [{\"file\": \"" +
                  path + "\", \"span\": [], \"text\": \"\", \"what\": \"\", \"before\": []}]}]")),
              no_answer)
        << path;
  }
}

// A place that no drawing of it bears ends the one answer, and not the generator.
TEST_F(WorkerTest, NamesPlacesThatCanBeDrawn) {
  const auto told = [&](const std::string& place, const std::string& severity = "0") {
    const std::string whole = "{\"file\": \"a.md\", \"excerpt\": \"abc\", " + place + "}";
    return found(
        "say {\"finding\": {\"diagnostics\": [{\"id\": \"E-x\", \"severity\": " + severity +
        ", \"message\": \"m\", \"detail\": \"\", \"cure\": \"\", \"edit\": [], \"notes\": "
        "[{\"message\": \"n\", \"place\": " +
        whole + "}], \"place\": " + whole + "}]}}");
  };
  const std::string no_answer = "the process that works on this gave no answer to it";
  const std::string good = R"("line": 1, "column": 2, "width": 9, "excerpt_column": 1)";
  EXPECT_EQ(told(good),
            "a.md:1:2: error: m [E-x]\n  1 | abc\n    |  ^~\n"
            "  note: a.md:1:2: n\n  1 | abc\n    |  ^~\n");
  EXPECT_EQ(told(good, "7"), no_answer);
  for (const char* place : {R"("line": 1, "column": 2, "width": 1, "excerpt_column": 100)",
                            R"("line": 1, "column": 2147483647, "width": 1, "excerpt_column": 1)",
                            R"("line": 1, "column": 2, "width": 2147483647, "excerpt_column": 1)",
                            R"("line": 1, "column": -2, "width": 1, "excerpt_column": -9)",
                            R"("line": -1, "column": 2, "width": -1, "excerpt_column": 1)",
                            R"("line": 1, "column": 9999999, "width": 1, "excerpt_column": 1)"}) {
    EXPECT_EQ(told(place), no_answer) << place;
  }
}

}  // namespace
}  // namespace mjcourse
