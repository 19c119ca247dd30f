// Timings: how long each task took, for people and for a browser's trace viewer.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "evaluate/evaluate.h"

namespace mjcourse {

// The tasks that took longest, in a table of lines; those that were kept are counted below it.
std::string timings_table(const std::vector<TaskTime>& times);

// All of them in Chrome's trace format (chrome://tracing, ui.perfetto.dev): a row for each thread.
void write_trace(const std::vector<TaskTime>& times, const std::filesystem::path& file);

}  // namespace mjcourse
