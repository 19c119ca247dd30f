#include "page/json_schema.h"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "lesson/json/json_fences.h"

namespace mjcourse {
namespace {

using nlohmann::ordered_json;

constexpr std::array kWheelKeys{
    Key{"size", KeyKind::whole, "In inches.", Need::there, {10, 30, "is in inches"}}};
constexpr Vocabulary kWheel{"wheel", kWheelKeys};

constexpr Key kTypeKey{"type", KeyKind::word, "Which car.", Need::filled};
constexpr std::array kVanKeys{
    kTypeKey, Key{"load", KeyKind::number, "In kg.", Need::none, {kAboveZero, 900, "is in kg"}},
    Key{"start", KeyKind::script, "How it starts.", Need::filled}};
constexpr Vocabulary kVan{"van", kVanKeys};
constexpr std::array kBusKeys{
    kTypeKey, Key{"wheels", KeyKind::objects, "Its wheels.", Need::filled, {}, &kWheel},
    Key{"roof", KeyKind::true_or_object, "Has it one?", Need::none, {}, &kWheel}};
constexpr Vocabulary kBus{"bus", kBusKeys};
constexpr std::array kCarKeys{kTypeKey};
constexpr std::array kCars{Variant{"van", &kVan}, Variant{"bus", &kBus}};
constexpr Vocabulary kCar{"car", kCarKeys, kCars};

TEST(JsonSchema, IsMadeOfAVocabulary) {
  EXPECT_EQ(json_schema({"car", "car", &kCar}, {}), ordered_json::parse(R"({
    "$schema": "http://json-schema.org/draft-07/schema#",
    "title": "mjcourse: a fence `car`",
    "type": "object",
    "properties": {
      "type": {"type": "string", "enum": ["van", "bus"], "description": "Which car."}},
    "required": ["type"],
    "additionalProperties": true,
    "oneOf": [
      {"type": "object",
       "properties": {
         "type": {"const": "van", "description": "Which car."},
         "load": {"type": "number", "exclusiveMinimum": 0, "maximum": 900, "description": "In kg."},
         "start": {"type": ["string", "array"], "items": {"type": "string"},
                   "description": "How it starts.", "minLength": 1, "minItems": 1}},
       "required": ["type", "start"],
       "additionalProperties": false},
      {"type": "object",
       "properties": {
         "type": {"const": "bus", "description": "Which car."},
         "wheels": {"type": "array", "items": {
             "type": "object",
             "properties": {"size": {"type": "integer", "minimum": 10, "maximum": 30,
                                     "description": "In inches."}},
             "required": ["size"],
             "additionalProperties": false},
           "description": "Its wheels.", "minItems": 1},
         "roof": {"anyOf": [{"type": "boolean"}, {
             "type": "object",
             "properties": {"size": {"type": "integer", "minimum": 10, "maximum": 30,
                                     "description": "In inches."}},
             "required": ["size"],
             "additionalProperties": false}],
           "description": "Has it one?"}},
       "required": ["type", "wheels"],
       "additionalProperties": false}]})"));
}

TEST(JsonSchema, LeavesOpenWhatOthersKnow) {
  const ordered_json plot = json_schema({"plot", "plot", vocabulary_of("plot")}, {});
  EXPECT_EQ(plot["additionalProperties"], true);
  EXPECT_EQ(plot["properties"]["data"]["additionalProperties"], false);
}

TEST(JsonSchema, HasAPlaceInTheSite) {
  EXPECT_EQ(schema_path({"lab", "lab simlab", nullptr}), "schemas/lab.schema.json");
}

}  // namespace
}  // namespace mjcourse
