// What has a CI or a scheduler check a course: a workflow, a batch script, a job.
// Tested by tests/system/schedulers.mjs.
#pragma once

#include <string>
#include <vector>

#include "base/files.h"
#include "cli/new_files.h"

namespace mjcourse {

// "github", "gitlab", "slurm", "kubernetes"; the first is what a new course has.
const std::vector<std::string>& ci_names();

// `name` is one of them.
std::vector<NewFile> ci_files(const Files& assets, const std::string& name);

}  // namespace mjcourse
