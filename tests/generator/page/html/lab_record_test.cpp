#include "page/html/lab_record.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace mjcourse {
namespace {

using nlohmann::json;

TEST(LabRecord, HoldsWhatTheReadoutsSaidInEachRun) {
  Lab lab;
  lab.readouts.resize(2);
  lab.readouts[0].label.text = "nq";
  lab.readouts[0].digits = 0;
  lab.readouts[1].label.text = "x";
  lab.readouts[1].digits = 2;
  LabResult result;
  result.runs = {{std::nullopt, {}, {{0, {13, -0.001}}, {250, {13, 0.5}}}},
                 {0, -1.5, {{0, {13, 1}}}},
                 {1, true, {}},
                 {2, 3, {}}};
  EXPECT_EQ(json::parse(lab_record(lab, result)), json::parse(R"({
      "readouts": ["nq", "x"], "predicted": null, "runs": [
        {"control": null, "value": null, "readings": [{"steps": 0, "values": ["13", "0.00"]},
                                                      {"steps": 250, "values": ["13", "0.50"]}]},
        {"control": 0, "value": -1.5, "readings": [{"steps": 0, "values": ["13", "1.00"]}]},
        {"control": 1, "value": true, "readings": []},
        {"control": 2, "value": 3, "readings": []}]})"));
}

TEST(LabRecord, HoldsWhatTheTracesOfAGhostWere) {
  Lab lab;
  lab.ghost = Lab::Ghost{};
  LabResult result;
  result.runs = {{std::nullopt, {}, {{0, {}, {0.1, 2}}}}};
  EXPECT_EQ(json::parse(lab_record(lab, result))["runs"][0]["readings"],
            json::parse(R"([{"steps": 0, "values": [], "ghost": [0.1, 2]}])"));
}

TEST(LabRecord, HoldsWhatAPredictionIsMeasuredBy) {
  Lab lab;
  lab.predict = Lab::Predict{};
  lab.predict->digits = 1;
  LabResult result;
  result.predicted = 0.25;
  EXPECT_EQ(json::parse(lab_record(lab, result))["predicted"], "0.2");
}

}  // namespace
}  // namespace mjcourse
