#include "session/live_session.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <deque>
#include <stdexcept>
#include <thread>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "session/write_behind_store.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// Which now and then cannot be read, for a reason that nobody foresaw.
class BreakingFiles : public DiskFiles {
 public:
  using DiskFiles::DiskFiles;
  tl::expected<std::string, std::string> read(const std::string& path) const override {
    if (broken) throw std::logic_error("not foreseen");
    return DiskFiles::read(path);
  }
  std::atomic<bool> broken = false;
};

class LiveSessionTest : public testing::Test {
 protected:
  LiveSessionTest() {
    write("content/course.yaml",
          "title: A course\nlevels:\n  - folder: 1-one\n    title: One\n    lessons: [1.1-a]\n");
    write_lesson("It has `{swing} model.nq`.");
    write_model(1);
  }

  void write(const std::string& path, const std::string& text) const {
    write_file(folder_.path() / path, text);
  }
  void write_lesson(const std::string& text) const {
    write("content/1-one/1.1-a.md", "---\ntitle: A\n---\n\n" + text + "\n");
  }
  // With so many hinges.
  void write_model(int hinges) const {
    std::string joints;
    for (int i = 0; i < hinges; ++i) joints += "<joint axis='0 1 0'/>";
    write("models/swing.xml",
          "<mujoco><worldbody><body>" + joints + "<geom size='.1'/></body></worldbody></mujoco>");
  }

  void begin(bool wants_guesses = false) {
    session_.emplace(
        EvaluationSettings{folder_.path(), assets_, &store_, 2},
        std::make_shared<DiskFiles>(folder_.path()),
        [this](const SnapshotPtr& snapshot) {
          const std::lock_guard lock(mutex_);
          told_.push_back(snapshot);
          more_.notify_all();
        },
        wants_guesses);
  }

  SnapshotPtr next() {
    std::unique_lock lock(mutex_);
    if (!more_.wait_for(lock, std::chrono::seconds(60), [&] { return !told_.empty(); })) {
      throw std::runtime_error("no snapshot came");
    }
    SnapshotPtr snapshot = told_.front();
    told_.pop_front();
    return snapshot;
  }
  // The next in which all is known.
  SnapshotPtr whole() {
    SnapshotPtr snapshot = next();
    while (snapshot->evaluation->open || snapshot->guessed) snapshot = next();
    return snapshot;
  }

  static std::string value_of(const Snapshot& snapshot) {
    const auto* value = snapshot.evaluation->lessons.at(0).get<ValueResult>(0);
    return value == nullptr ? "" : value->text;
  }

  const TemporaryFolder folder_;
  BreakingFiles assets_{MJCOURSE_ASSETS};
  WriteBehindStore store_{nullptr};
  std::mutex mutex_;
  std::condition_variable more_;
  std::deque<SnapshotPtr> told_;
  std::optional<LiveSession> session_;  // last: it uses the rest
};

TEST_F(LiveSessionTest, TellsWhatIsKnownAndThenWhatIsTrue) {
  begin();
  const SnapshotPtr first = next();
  EXPECT_TRUE(first->evaluation->open);
  EXPECT_EQ(value_of(*first), "");
  EXPECT_EQ(value_of(*whole()), "1");
}

TEST_F(LiveSessionTest, ShowsFormerResultsUntilTheyAreKnownAnew) {
  begin();
  whole();
  write_model(2);
  session_->changed();
  const SnapshotPtr first = next();
  EXPECT_TRUE(first->evaluation->open);
  EXPECT_EQ(first->evaluation->lessons[0].open, std::set<std::size_t>{0});
  EXPECT_EQ(value_of(*first), "1");
  EXPECT_EQ(value_of(*whole()), "2");
}

TEST_F(LiveSessionTest, HasNoNeedToWorkForWhatItKnows) {
  begin();
  whole();
  write_lesson("Now it has `{swing} model.nq`, as before.");
  session_->changed();
  const SnapshotPtr first = next();
  EXPECT_FALSE(first->evaluation->open);
  EXPECT_EQ(value_of(*first), "1");
}

TEST_F(LiveSessionTest, GuessesThatAnEditOfTextChangesNothingElse) {
  begin(true);
  whole();
  write_lesson("Now it has `{swing} model.nq`, as before.");
  session_->changed();
  const SnapshotPtr first = next();
  EXPECT_TRUE(first->guessed);
  EXPECT_EQ(value_of(*first), "1");
  EXPECT_NE(first->course.lessons[0].source->text().find("Now"), std::string_view::npos);
  const SnapshotPtr second = next();
  EXPECT_FALSE(second->guessed);
  EXPECT_EQ(value_of(*second), "1");
}

TEST_F(LiveSessionTest, ShowsAFaultOfItsOwnUntilTheNextEdit) {
  for (const bool wants_guesses : {false, true}) {
    write_lesson("It has `{swing} model.nq`.");
    assets_.broken = false;
    begin(wants_guesses);
    whole();
    assets_.broken = true;
    write_model(wants_guesses ? 3 : 2);
    write_lesson("It has `{swing} model.nq`, `{swing} model.nv`.");
    session_->changed();
    SnapshotPtr broken = next();
    while (broken->readable) broken = next();
    ASSERT_EQ(broken->diagnostics.size(), 1u);
    EXPECT_EQ(broken->diagnostics[0].id, "E-preview");
    EXPECT_EQ(broken->diagnostics[0].message, "not foreseen");
    assets_.broken = false;
    write_lesson("Now it has `{swing} model.nq`.");
    session_->changed();
    EXPECT_EQ(value_of(*whole()), wants_guesses ? "3" : "2");
    session_.reset();
    told_.clear();
  }
}

TEST_F(LiveSessionTest, LooksAfterAWrongGuess) {
  begin(true);
  whole();
  write_model(2);
  write_lesson("Now it has `{swing} model.nq`.");
  session_->changed();
  EXPECT_TRUE(next()->guessed);
  EXPECT_EQ(value_of(*whole()), "2");
}

TEST_F(LiveSessionTest, ShowsAtOnceThatAnEditedProgramRuns) {
  const auto save = [&](const std::string& text) {
    const std::string code = "#include <cstdio>\n\nint main() { std::puts(\"" + text + "\"); }\n";
    write("examples/say.cpp", code);
    write_lesson("```cpp file=examples/say.cpp\n" + code + "```");
  };
  const auto said = [](const Snapshot& snapshot) {
    return snapshot.evaluation->lessons.at(0).get<ExampleResult>(0)->output;
  };
  save("one");
  begin(true);
  EXPECT_EQ(said(*whole()), "one\n");
  save("two");
  session_->changed();
  const SnapshotPtr first = next();
  EXPECT_TRUE(first->guessed);
  EXPECT_TRUE(first->evaluation->open);
  EXPECT_EQ(first->evaluation->lessons[0].open, std::set<std::size_t>{0});
  EXPECT_EQ(said(*first), "one\n");
  EXPECT_NE(first->evaluation->lessons[0].get<ExampleResult>(0)->code.find("two"),
            std::string::npos);
  EXPECT_EQ(said(*whole()), "two\n");
}

TEST_F(LiveSessionTest, DoesNotGuessWhatABlockIs) {
  begin(true);
  whole();
  for (const char* text : {"It has `{swing} model.nv`.", "None.", "`{swing} 1`, `{swing} 2`."}) {
    write_lesson(text);
    session_->changed();
    const SnapshotPtr first = next();
    EXPECT_FALSE(first->guessed) << text;
    if (first->evaluation->open) whole();
  }
  // Nor where no lesson was edited.
  write_model(3);
  session_->changed();
  EXPECT_FALSE(next()->guessed);
}

TEST_F(LiveSessionTest, KeepsMistakesUntilTheyAreKnownToBeMended) {
  write_lesson("It has `{swing} model.nqq`.");
  begin();
  ASSERT_EQ(whole()->diagnostics.size(), 1);
  write_lesson("And it has `{swing} model.nqq`.");
  session_->changed();
  const SnapshotPtr first = next();
  EXPECT_TRUE(first->evaluation->open);
  EXPECT_EQ(first->diagnostics.size(), 1);
  EXPECT_EQ(whole()->diagnostics.size(), 1);
  write_lesson("And it has `{swing} model.nq`.");
  session_->changed();
  EXPECT_TRUE(whole()->diagnostics.empty());
}

TEST_F(LiveSessionTest, TellsWhyACourseCannotBeRead) {
  begin();
  whole();
  fs::remove(folder_.path() / "content/course.yaml");
  session_->changed();
  const SnapshotPtr none = next();
  EXPECT_FALSE(none->readable);
  ASSERT_EQ(none->diagnostics.size(), 1);
  EXPECT_EQ(none->diagnostics[0].id, "E-course-yaml");
}

TEST_F(LiveSessionTest, EndsWorkThatANewerSaveMakesVain) {
  write_lesson("It has `{swing} model.nq`.\n\n```cpp file=examples/sleep.cpp timeout=300\n```");
  write("examples/sleep.cpp", "#include <unistd.h>\n\nint main() { sleep(300); }\n");
  begin();
  EXPECT_TRUE(next()->evaluation->open);
  std::this_thread::sleep_for(std::chrono::seconds(2));  // it is compiled, or runs already
  write_lesson("It has only `{swing} model.nq`.");
  session_->changed();
  EXPECT_EQ(value_of(*whole()), "1");
}

TEST_F(LiveSessionTest, EndsWhileItWorks) {
  begin();
  next();
  session_.reset();
}

}  // namespace
}  // namespace mjcourse
