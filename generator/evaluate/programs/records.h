// Records: what a program told its lesson, out of the file that the helper header writes.
//
// A line for each record: {"result": NAME, "value": …}, "table" or "snapshot" in the same way. What
// is wrong with one is the author's to mend, so each fault names the record; the others are kept.
#pragma once

#include <string>
#include <vector>

#include "findings/result.h"

namespace mjcourse {

struct RecordFault {
  std::string name;  // of the record; empty where not even that could be read
  std::string message, cure;
};

Records read_records(const std::string& lines, std::vector<RecordFault>& faults);

}  // namespace mjcourse
