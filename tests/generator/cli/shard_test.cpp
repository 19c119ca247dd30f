#include "cli/shard.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

namespace mjcourse {
namespace {

// What `text` comes to under a scheduler that sets these: "2/4", or what is wrong.
std::string shard(const std::string& text, const std::map<std::string, std::string>& set = {}) {
  for (const auto& [name, value] : set) setenv(name.c_str(), value.c_str(), 1);
  const auto found = shard_of(text);
  for (const auto& [name, value] : set) unsetenv(name.c_str());
  if (!found) return found.error();
  return std::to_string(found->number) + "/" + std::to_string(found->count);
}

TEST(Shard, IsSaidInTwoNumbers) {
  EXPECT_EQ(shard("1/1"), "1/1");
  EXPECT_EQ(shard("2/4"), "2/4");
  EXPECT_EQ(shard("10000/10000"), "10000/10000");
  for (const char* wrong : {"0/4", "5/4", "2", "2/", "/4", "2/4/", "-1/4", "2/4x", "1/10001",
                            "2 /4", "99999999999999999999/4"}) {
    EXPECT_EQ(shard(wrong),
              "--shard takes I/N, such as 2/4 for the second of four jobs, or auto; `" +
                  std::string(wrong) + "` is neither");
  }
}

TEST(Shard, IsWhatASchedulerSays) {
  EXPECT_EQ(shard("auto", {{"SLURM_ARRAY_TASK_ID", "3"},
                           {"SLURM_ARRAY_TASK_MIN", "1"},
                           {"SLURM_ARRAY_TASK_COUNT", "4"}}),
            "3/4");
  EXPECT_EQ(shard("auto", {{"SLURM_ARRAY_TASK_ID", "14"},
                           {"SLURM_ARRAY_TASK_MIN", "10"},
                           {"SLURM_ARRAY_TASK_STEP", "2"},
                           {"SLURM_ARRAY_TASK_COUNT", "3"}}),
            "3/3");
  EXPECT_EQ(shard("auto", {{"JOB_COMPLETION_INDEX", "0"}, {"MJCOURSE_SHARDS", "8"}}), "1/8");
  EXPECT_EQ(shard("auto", {{"CI_NODE_INDEX", "4"}, {"CI_NODE_TOTAL", "4"}}), "4/4");
  EXPECT_EQ(shard("auto", {{"BUILDKITE_PARALLEL_JOB", "1"}, {"BUILDKITE_PARALLEL_JOB_COUNT", "2"}}),
            "2/2");
}

TEST(Shard, IsNotGuessedWhereASchedulerSaysTooLittle) {
  EXPECT_EQ(shard("auto"),
            "--shard auto: no scheduler has numbered this job: none of SLURM_ARRAY_TASK_ID, "
            "JOB_COMPLETION_INDEX, CI_NODE_INDEX, BUILDKITE_PARALLEL_JOB is set; say it yourself, "
            "as in --shard 2/4");
  EXPECT_EQ(shard("auto", {{"JOB_COMPLETION_INDEX", "0"}}),
            "--shard auto: Kubernetes does not say which job of how many this is: "
            "JOB_COMPLETION_INDEX=0, MJCOURSE_SHARDS is not set");
  EXPECT_EQ(shard("auto", {{"SLURM_ARRAY_TASK_ID", "9"},
                           {"SLURM_ARRAY_TASK_MIN", "1"},
                           {"SLURM_ARRAY_TASK_COUNT", "4"}}),
            "--shard auto: Slurm does not say which job of how many this is: "
            "SLURM_ARRAY_TASK_ID=9, SLURM_ARRAY_TASK_COUNT=4, SLURM_ARRAY_TASK_MIN=1");
}

}  // namespace
}  // namespace mjcourse
