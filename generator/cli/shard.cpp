#include "cli/shard.h"

#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace mjcourse {
namespace {

constexpr std::size_t kMostShards = 10'000;

// How a scheduler numbers its jobs.
struct Numbering {
  const char* scheduler;
  const char* index;
  const char* count;
  const char* first;  // a variable with the index of the first job, or the index itself
  const char* step;   // a variable with the difference of two jobs; or null
};
constexpr std::array<Numbering, 4> kNumberings{
    {{"Slurm", "SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN",
      "SLURM_ARRAY_TASK_STEP"},
     {"Kubernetes", "JOB_COMPLETION_INDEX", "MJCOURSE_SHARDS", "0", nullptr},
     {"GitLab", "CI_NODE_INDEX", "CI_NODE_TOTAL", "1", nullptr},
     {"Buildkite", "BUILDKITE_PARALLEL_JOB", "BUILDKITE_PARALLEL_JOB_COUNT", "0", nullptr}}};

std::optional<std::size_t> number_in(std::string_view text) {
  std::size_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return number;
}

std::string value_of(const char* variable) {
  const char* const value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

std::optional<Shard> checked(std::optional<std::size_t> number, std::optional<std::size_t> count) {
  if (!number || !count || *number < 1 || *number > *count || *count > kMostShards) {
    return std::nullopt;
  }
  return Shard{*number, *count};
}

tl::expected<Shard, std::string> shard_of(const Numbering& numbering) {
  const std::string index = value_of(numbering.index), count = value_of(numbering.count);
  const std::optional<std::size_t> known = number_in(numbering.first);
  const std::string first = known ? numbering.first : value_of(numbering.first);
  const std::string step = numbering.step == nullptr ? "1" : value_of(numbering.step);
  const auto at = number_in(index), from = number_in(first),
             width = number_in(step.empty() ? "1" : step);
  if (at && from && width && *at >= *from && *width > 0) {
    if (const auto shard = checked((*at - *from) / *width + 1, number_in(count))) return *shard;
  }
  const auto told = [](const char* name, const std::string& value) {
    return std::string(name) + (value.empty() ? " is not set" : "=" + value);
  };
  return tl::unexpected(
      "--shard auto: " + std::string(numbering.scheduler) +
      " does not say which job of how many this is: " + told(numbering.index, index) + ", " +
      told(numbering.count, count) + (known ? "" : ", " + told(numbering.first, first)));
}

}  // namespace

tl::expected<Shard, std::string> shard_of(const std::string& text) {
  if (text == "auto") {
    std::string names;
    for (const Numbering& one : kNumberings) {
      if (!value_of(one.index).empty()) return shard_of(one);
      names += (names.empty() ? "" : ", ") + std::string(one.index);
    }
    return tl::unexpected("--shard auto: no scheduler has numbered this job: none of " + names +
                          " is set; say it yourself, as in --shard 2/4");
  }
  const std::size_t slash = text.find('/');
  if (slash != text.npos) {
    const auto shard = checked(number_in(std::string_view(text).substr(0, slash)),
                               number_in(std::string_view(text).substr(slash + 1)));
    if (shard) return *shard;
  }
  return tl::unexpected("--shard takes I/N, such as 2/4 for the second of four jobs, or auto; `" +
                        text + "` is neither");
}

}  // namespace mjcourse
