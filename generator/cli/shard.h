// Which share of the work a command line asks for: `--shard 2/4`, or as a scheduler says it.
// Tested by tests/generator/cli/shard_test.cpp.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "evaluate/shard.h"

namespace mjcourse {

// `text` is I/N, or `auto` for what a scheduler's variables say: those of Slurm's job arrays, of
// Kubernetes' Indexed Jobs (with MJCOURSE_SHARDS), of GitLab's `parallel:` and of Buildkite's
// `parallelism:`. What is wrong with it.
tl::expected<Shard, std::string> shard_of(const std::string& text);

}  // namespace mjcourse
