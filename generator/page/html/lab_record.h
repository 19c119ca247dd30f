// What the rehearsal of a lab found, for everyone to compare with what the page does.
#pragma once

#include <string>

#include "findings/result.h"
#include "lesson/blocks/lab.h"

namespace mjcourse {

// JSON: the readouts' labels; the runs; and what a prediction is measured by, null where there is
// none. A run has its control (an index, or null for none), the value that it took, and what the
// readouts said a number of steps later, with the numbers of the plots' traces of a ghost.
std::string lab_record(const Lab& lab, const LabResult& result);

}  // namespace mjcourse
