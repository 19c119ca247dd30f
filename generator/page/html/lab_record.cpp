#include "page/html/lab_record.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "page/html/fixed_number.h"

namespace mjcourse {
namespace {

using nlohmann::json;

json json_of(const ControlValue& value) {
  if (const auto* on = std::get_if<bool>(&value)) return *on;
  if (const auto* option = std::get_if<int>(&value)) return *option;
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return nullptr;
}

json json_of(const LabReading& reading, const Lab& lab) {
  json values = json::array();
  for (std::size_t i = 0; i < lab.readouts.size(); ++i) {
    values.push_back(fixed_number(reading.values[i], lab.readouts[i].digits));
  }
  json found{{"steps", reading.steps}, {"values", std::move(values)}};
  if (lab.ghost) found["ghost"] = reading.ghost;
  return found;
}

}  // namespace

std::string lab_record(const Lab& lab, const LabResult& result) {
  json labels = json::array(), runs = json::array(), predicted = nullptr;
  for (const Lab::Readout& readout : lab.readouts) labels.push_back(readout.label.text);
  for (const LabRunResult& run : result.runs) {
    json readings = json::array();
    for (const LabReading& reading : run.readings) readings.push_back(json_of(reading, lab));
    runs.push_back({{"control", run.control ? json(*run.control) : json(nullptr)},
                    {"value", json_of(run.value)},
                    {"readings", std::move(readings)}});
  }
  if (lab.predict && result.predicted) {
    predicted = fixed_number(*result.predicted, lab.predict->digits);
  }
  return json{{"readouts", labels}, {"runs", runs}, {"predicted", predicted}}.dump(1) + "\n";
}

}  // namespace mjcourse
