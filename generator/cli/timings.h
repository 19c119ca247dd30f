// Timings: how long each task took, for people and for a browser's trace viewer.
#pragma once

#include <string>
#include <vector>

#include "base/out_folder.h"
#include "evaluate/evaluate.h"
#include "remote/remote_store.h"

namespace mjcourse {

// The tasks that took longest, in a table of lines; those that were kept are counted below it.
std::string timings_table(const std::vector<TaskTime>& times);

// What a shared store gave so far, and how long that took, in a line.
std::string traffic_text(const RemoteStore::Traffic& traffic);

// All of them in Chrome's trace format (chrome://tracing, ui.perfetto.dev): a row for each thread.
// Throws as OutFolder does.
void write_trace(const std::vector<TaskTime>& times, const OutPlace& place);

}  // namespace mjcourse
