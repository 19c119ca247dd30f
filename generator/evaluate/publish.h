// Publishing: what programs reported, for the lessons that quote it.
// Tested by tests/store/dependencies.mjs.
#pragma once

#include "cache/fingerprints.h"
#include "evaluate/context/reports.h"
#include "evaluate/scheduler.h"

namespace mjcourse {

// `records` are those of `tasks`, and must outlive `reports`.
void publish(const Tasks& tasks, const TaskRecords& records, Reports& reports,
             Fingerprints& fingerprints);

}  // namespace mjcourse
