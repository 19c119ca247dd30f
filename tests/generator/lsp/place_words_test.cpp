#include "lsp/place_words.h"

#include <gtest/gtest.h>

#include <string>

namespace mjcourse {
namespace {

std::string key_at(std::string_view fence, std::string_view before) {
  const PlaceWords words = words_at(fence, json_place(before));
  return words.key != nullptr ? std::string(words.key->name) : "";
}

std::string object_at(std::string_view fence, std::string_view before) {
  const PlaceWords words = words_at(fence, json_place(before));
  return words.object != nullptr ? std::string(words.object->name) : "";
}

TEST(PlaceWords, FollowKeys) {
  EXPECT_EQ(object_at("lab", "{"), "lab");
  EXPECT_EQ(key_at("lab", R"({"model": ")"), "model");
  EXPECT_EQ(object_at("lab", R"({"plots": [{"traces": [{)"), "trace");
  EXPECT_EQ(object_at("lab", R"({"plots": [{"traces": [{"label": "x"}], )"), "plot");
  EXPECT_EQ(object_at("lab", R"({"unknown": {)"), "");
  EXPECT_EQ(object_at("cpp", "{"), "");
}

TEST(PlaceWords, AWordDecidesWhatAnObjectIs) {
  EXPECT_EQ(object_at("lab", R"({"controls": [{)"), "control");
  EXPECT_EQ(object_at("lab", R"({"controls": [{"type": "slider", )"), "slider");
  EXPECT_EQ(object_at("lab", R"({"controls": [{"type": ")"), "control");
  EXPECT_EQ(key_at("lab", R"({"controls": [{"type": ")"), "type");
  EXPECT_EQ(object_at("lab", R"({"controls": [{"type": "slider", "type": ")"), "control");
  EXPECT_EQ(key_at("quiz", R"({"questions": [{"kind": "numeric", "verify": [{"value": ")"),
            "value");
}

TEST(PlaceWords, TakeWhatIsNotRight) {
  for (const char* before : {"}}}]]", R"({]}{"a)", R"({"a" "b" "c" [}])", "{{{{[[[[", ","}) {
    EXPECT_EQ(key_at("lab", before), "") << before;
  }
}

}  // namespace
}  // namespace mjcourse
