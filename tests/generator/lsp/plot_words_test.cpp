#include "lsp/plot_words.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// A spec has an encoding, with a channel that is an object or a list of them, and layers.
const PlotGrammar kGrammar{{{"o", {}, {{"encoding", "", 1}, {"layer", "", 3}}},
                            {"o", {}, {{"x", "", 2}}},
                            {"ao", {}, {{"field", "", 4}}, {}, 2},
                            {"a", {}, {}, {}, 0},
                            {"s", {}, {}}},
                           {}};

std::string first_key(std::string_view before) {
  const PlotGrammar::State* state = plot_object_at(kGrammar, json_place(before));
  return state != nullptr && !state->keys.empty() ? state->keys.front().name : "";
}

TEST(PlotWords, FollowTheSpecInwards) {
  EXPECT_EQ(first_key("{"), "encoding");
  EXPECT_EQ(first_key(R"({"encoding": {)"), "x");
  EXPECT_EQ(first_key(R"({"encoding": {"x": {)"), "field");
}

TEST(PlotWords, TellAListFromWhatStandsInIt) {
  EXPECT_EQ(first_key(R"({"encoding": {"x": [{"field": "a"}, {)"), "field");
  EXPECT_EQ(first_key(R"({"layer": [{"encoding": {)"), "x");
  EXPECT_EQ(first_key(R"({"layer": {)"), "");
}

TEST(PlotWords, AreNoneOutsideOfTheSpec) {
  EXPECT_EQ(first_key(""), "");
  EXPECT_EQ(first_key(R"({"data": {)"), "");
  EXPECT_EQ(plot_object_at({}, json_place("{")), nullptr);
}

}  // namespace
}  // namespace mjcourse
