#include "page/plot_schema.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace mjcourse {
namespace {

using nlohmann::ordered_json;

TEST(PlotSchema, AddsWhatASpecMaySay) {
  const PlotGrammar grammar{{{"o", {}, {{"mark", "What is drawn.", 1}, {"layer", "", 2}}},
                             {"os", {{"bar", "line"}}, {}, 3},
                             {"a", {}, {}, {}, 0},
                             {"nz"}},
                            {"href"}};
  ordered_json schema{{"type", "object"},
                      {"properties", {{"data", {{"type", "string"}}}}},
                      {"additionalProperties", true}};
  add_plot_schema(grammar, schema);
  EXPECT_EQ(schema, ordered_json::parse(R"({
    "type": "object",
    "properties": {
      "data": {"type": "string"},
      "mark": {"description": "What is drawn.", "allOf": [{"$ref": "#/definitions/1"}]},
      "layer": {"allOf": [{"$ref": "#/definitions/2"}]}},
    "additionalProperties": false,
    "definitions": {
      "0": {"type": ["object"],
            "properties": {
              "mark": {"description": "What is drawn.", "allOf": [{"$ref": "#/definitions/1"}]},
              "layer": {"allOf": [{"$ref": "#/definitions/2"}]}},
            "additionalProperties": false},
      "1": {"anyOf": [{"enum": ["bar", "line"]}, {"type": ["object"]}],
            "properties": {},
            "additionalProperties": {"$ref": "#/definitions/3"},
            "propertyNames": {"not": {"enum": ["href"]}}},
      "2": {"type": ["array"], "items": {"$ref": "#/definitions/0"}},
      "3": {"type": ["number", "null"]}}})"));
}

TEST(PlotSchema, LeavesOpenWhatNobodyKnows) {
  ordered_json schema{{"type", "object"}, {"additionalProperties", true}};
  const ordered_json before = schema;
  add_plot_schema({}, schema);
  EXPECT_EQ(schema, before);
}

}  // namespace
}  // namespace mjcourse
