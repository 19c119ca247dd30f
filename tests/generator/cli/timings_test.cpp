#include "cli/timings.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

const std::vector<TaskTime> kTimes{{"a lab", 0, 0, 0.25, false},
                                   {"a value", 1, 0, 0.001, true},
                                   {"a program", 1, 0.001, 1.5, false, 0.96}};

TEST(Timings, NameTheLongestFirst) {
  EXPECT_EQ(timings_table(kTimes),
            "   1500.0 ms  a program, 1.0 s of it in the page\n"
            "    250.0 ms  a lab\n"
            "    960.0 ms  of all these in the page\n"
            "      1.0 ms  1 result kept from before\n");
  const std::vector<TaskTime> many(22, {"a lab", 0, 0, 0.25, false});
  EXPECT_TRUE(timings_table(many).ends_with("    500.0 ms  2 other tasks\n"));
}

TEST(Timings, BecomeATrace) {
  const TemporaryFolder folder;
  write_trace(kTimes, {OutFolder(folder.path()), "trace.json"});
  const auto trace = nlohmann::json::parse(DiskFiles(folder.path()).read("trace.json").value());
  const auto& events = trace.at("traceEvents");
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[1].at("cat"), "kept");
  EXPECT_EQ(events[2].at("name"), "a program");
  EXPECT_EQ(events[2].at("ts"), 1000);
  EXPECT_EQ(events[2].at("dur"), 1'500'000);
  EXPECT_EQ(events[2].at("tid"), 1);
  EXPECT_EQ(events[2].at("args").at("seconds in the page"), 0.96);
}

}  // namespace
}  // namespace mjcourse
