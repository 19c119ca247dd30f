#include "evaluate/context/reports.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

class ReportsTest : public testing::Test {
 protected:
  ReportsTest() {
    tells_.records.tables["energy"] = {{"t", {0, 1}}};
    tells_.records.snapshots["start"] = {{"qpos", {2}}};
    reports_.add("tell", &tells_);
    reports_.add("silent", &silent_);
    reports_.add("failed", nullptr);
  }

  // What is said of `example`/`name`, which is the lesson's only line.
  template <typename Value>
  std::string said(const Value* (Reports::*find)(const LocatedText&, const LocatedText&,
                                                 const SourceText&, Diagnostics&) const,
                   const std::string& example, const std::string& name) {
    const SourceText lesson("x.md", example + "/" + name);
    ReadingOf reading;
    const Value* found = (reports_.*find)(
        located(lesson, {0, example.size()}),
        located(lesson, {example.size() + 1, lesson.text().size()}), lesson, reading.diagnostics);
    return (found != nullptr ? "found\n" : "") + underlined_mistakes(reading);
  }
  std::string table(const std::string& example, const std::string& name) {
    return said(&Reports::find_table, example, name);
  }
  std::string snapshot(const std::string& example, const std::string& name) {
    return said(&Reports::find_snapshot, example, name);
  }

  ExampleResult tells_, silent_;
  Reports reports_;
};

TEST_F(ReportsTest, FindTablesAndSnapshots) {
  EXPECT_EQ(table("tell", "energy"), "found\n");
  EXPECT_EQ(snapshot("tell", "start"), "found\n");
}

TEST_F(ReportsTest, NameTheExamplesThatThereAre) {
  EXPECT_EQ(table("tel", "energy"),
            "E-example-unknown <tel> no lesson has an example `tel` | did you mean `tell`?\n");
}

TEST_F(ReportsTest, NameTheTablesThatThereAre) {
  EXPECT_EQ(table("tell", "enrgy"),
            "E-example-table <enrgy> the example `tell` reports no table `enrgy` | did you mean "
            "`energy`?\n");
  EXPECT_EQ(table("silent", "energy"),
            "E-example-table <energy> the example `silent` reports no table `energy` | report it "
            "there: `table(\"energy\", …)`\n");
}

TEST_F(ReportsTest, NameTheSnapshotsThatThereAre) {
  EXPECT_EQ(snapshot("tell", "stat"),
            "E-example-snapshot <stat> the example `tell` reports no snapshot `stat` | did you "
            "mean `start`?\n");
  EXPECT_EQ(snapshot("silent", "start"),
            "E-example-snapshot <start> the example `silent` reports no snapshot `start` | report "
            "it there: `snapshot(\"start\", model, data)`\n");
}

TEST_F(ReportsTest, SayNothingOfWhatFailedWhereItStands) {
  EXPECT_EQ(table("failed", "energy"), "");
}

}  // namespace
}  // namespace mjcourse
