// What a lab reads of its simulation: readouts, and the plots' traces.
#pragma once

#include <vector>

#include "lesson/blocks/lab.h"
#include "lesson/json/json_object.h"

namespace mjcourse {

// Without those that read nothing.
std::vector<Lab::Readout> read_readouts(JsonObject& lab, Reading& reading);
std::vector<Lab::Plot> read_lab_plots(JsonObject& lab, Reading& reading);

}  // namespace mjcourse
