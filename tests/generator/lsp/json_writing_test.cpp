#include "lsp/json_writing.h"

#include <gtest/gtest.h>

#include <functional>

namespace mjcourse {
namespace {

// "label → what is written" of what is added behind `before`; the label itself where it is written
// as it is.
std::string written(const std::string& before, bool closed,
                    const std::function<void(JsonWriting&)>& add) {
  const JsonPlace place = json_place(before);
  Suggestions found;
  JsonWriting writing(place, closed, found);
  add(writing);
  std::string all;
  for (const Suggestion& one : found.all) {
    all += one.name + (one.text.empty() ? "" : " → " + one.text) + "|";
  }
  return all;
}

std::string keys(const std::string& before, bool closed = false) {
  return written(before, closed, [](JsonWriting& writing) {
    writing.add_key("title", "lab", "What it shows.");
    writing.add_key("model", "lab", "What is simulated.");
  });
}

std::string values(const std::string& before) {
  return written(before, false, [](JsonWriting& writing) {
    writing.add_text("swing", "model of the course");
    writing.add_booleans("whether");
  });
}

TEST(JsonWriting, GivesAKeyTheQuotesThatItLacks) {
  EXPECT_EQ(keys("{"), R"(title → "title": |model → "model": |)");
  EXPECT_EQ(keys(R"({"ti)"), R"(title → title": |model → model": |)");
  EXPECT_EQ(keys(R"({"ti)", true), "title → title|model → model|");
}

TEST(JsonWriting, GivesNoKeyTwice) {
  EXPECT_EQ(keys(R"({"title": "x", )"), R"(model → "model": |)");
  EXPECT_EQ(keys(R"({"title": "x", "plot": {)"), R"(title → "title": |model → "model": |)");
}

TEST(JsonWriting, GivesAStringTheQuotesThatItLacks) {
  EXPECT_EQ(values(R"({"model": )"), R"(swing → "swing"|true|false|)");
}

TEST(JsonWriting, GivesNoBooleanInAString) {
  EXPECT_EQ(values(R"({"model": "sw)"), "swing|");
}

}  // namespace
}  // namespace mjcourse
