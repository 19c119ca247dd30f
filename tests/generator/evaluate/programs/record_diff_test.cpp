#include "evaluate/programs/record_diff.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

Records results(std::map<std::string, Reported> all) {
  return {std::move(all), {}, {}};
}

TEST(RecordDiff, LeavesRoomForRounding) {
  EXPECT_EQ(record_diff(results({{"x", 1.0}}), results({{"x", 1.000005}})), "");
  EXPECT_EQ(record_diff(results({{"x", 1e-12}}), results({{"x", -1e-12}})), "");
  EXPECT_EQ(record_diff(results({{"x", 1.0}}), results({{"x", 1.0001}})),
            "the result `x` is 1.0001 there, and 1.0 natively");
}

TEST(RecordDiff, NamesWhatIsThereOnce) {
  EXPECT_EQ(record_diff(results({{"x", 1.0}}), {}), "the result `x` is missing there");
  EXPECT_EQ(record_diff({}, results({{"x", 1.0}})), "the result `x` is there alone");
}

TEST(RecordDiff, ComparesTextsAndLists) {
  EXPECT_EQ(record_diff(results({{"x", "a"}}), results({{"x", "b"}})),
            "the result `x` is \"b\" there, and \"a\" natively");
  EXPECT_EQ(record_diff(results({{"x", std::vector<double>{1, 2}}}),
                        results({{"x", std::vector<double>{1, 3}}})),
            "the result `x` is another");
  EXPECT_EQ(record_diff(results({{"x", 2.0}}), results({{"x", "2"}})),
            "the result `x` is \"2\" there, and 2.0 natively");
}

TEST(RecordDiff, ComparesTablesAndSnapshots) {
  const Records native{{}, {{"t", {{"a", {1, 2}}}}}, {{"s", {{"qpos", {1}}}}}};
  EXPECT_EQ(record_diff(native, native), "");
  Records page = native;
  page.tables["t"][0].name = "b";
  EXPECT_EQ(record_diff(native, page), "the table `t` is another");
  page = native;
  page.snapshots["s"]["qpos"] = {1, 2};
  EXPECT_EQ(record_diff(native, page), "the snapshot `s` is another");
}

TEST(RecordDiff, ComparesWhatWasChecked) {
  const auto with = [](std::vector<Check> checks) {
    Records records;
    records.checks = std::move(checks);
    return records;
  };
  const Check holds{"it falls", true, "", ""}, fails{"it falls", false, "", "it is 1"};
  EXPECT_EQ(record_diff(with({holds}), with({holds})), "");
  EXPECT_EQ(record_diff(with({holds}), with({fails})), "the check `it falls` fails there");
  EXPECT_EQ(record_diff(with({fails}), with({holds})),
            "the check `it falls` holds there, and not natively");
  EXPECT_EQ(record_diff(with({holds}), with({})), "the check `it falls` is not made there");
  EXPECT_EQ(record_diff(with({}), with({holds})), "the check `it falls` is made there alone");
}

}  // namespace
}  // namespace mjcourse
