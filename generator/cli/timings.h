// Timings: how long each task took, for people and for a browser's trace viewer.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "evaluate/evaluate.h"
#include "remote/remote_store.h"

namespace mjcourse {

// The tasks that took longest, in a table of lines; those that were kept are counted below it.
std::string timings_table(const std::vector<TaskTime>& times);

// What a shared store gave so far, and how long that took, in a line.
std::string traffic_text(const RemoteStore::Traffic& traffic);

// All of them in Chrome's trace format (chrome://tracing, ui.perfetto.dev): a row for each thread.
void write_trace(const std::vector<TaskTime>& times, const std::filesystem::path& file);

}  // namespace mjcourse
