#include "lsp/json_place.h"

#include <gtest/gtest.h>

#include <chrono>

namespace mjcourse {
namespace {

TEST(JsonPlace, IsAtAKeyOrAValue) {
  EXPECT_TRUE(json_place("{").at_key());
  EXPECT_TRUE(json_place(R"({"ti)").at_key());
  EXPECT_TRUE(json_place(R"({"title": "x", )").at_key());
  EXPECT_FALSE(json_place(R"({"title": )").at_key());
  EXPECT_FALSE(json_place(R"({"title": "x)").at_key());
  EXPECT_FALSE(json_place("").at_key());
  EXPECT_FALSE(json_place(R"({"controls": [)").at_key());
}

TEST(JsonPlace, KnowsThePartOfItsString) {
  EXPECT_EQ(json_place(R"({"ti)").part, "ti");
  EXPECT_EQ(json_place(R"({"run": ["a", "say(\"hi)").part, "say(\"hi");
  EXPECT_FALSE(json_place(R"({"title": "x")").in_string);
}

TEST(JsonPlace, FindsTheNearestModel) {
  EXPECT_EQ(json_place(R"({"model": "a", "goal": {"model": "b", "run": ")").text("model"), "b");
  EXPECT_EQ(json_place(R"({"model": "a", "goal": {"model": "b"}, "x": ")").text("model"), "a");
}

TEST(JsonPlace, RemembersTheStringsOfObjectsThatAreClosed) {
  EXPECT_EQ(json_place(R"({"data": {"name": "a/b"}, "mark": )").text_within("data", "name"), "a/b");
  EXPECT_EQ(json_place(R"({"layer": [{"name": "c"}], "mark": )").text_within("layer", "name"), "");
}

TEST(JsonPlace, CountsListsWithinAnObject) {
  const JsonPlace place = json_place(R"({"a": [[{"b": [)");
  EXPECT_EQ(place.objects[0].lists, 0);
  EXPECT_EQ(place.objects[1].lists, 2);
  EXPECT_EQ(place.lists, 1);
  EXPECT_EQ(json_place(R"({"a": [1, 2], "b": )").lists, 0);
}

TEST(JsonPlace, IsNowhereDeeperThanALessonIsRead) {
  const auto nested = [](std::string_view open, int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += open;
    return json_place(text).objects.size();
  };
  EXPECT_EQ(nested(R"({"a":)", 200), 200U);
  EXPECT_EQ(nested(R"({"a":)", 201), 0U);
  EXPECT_EQ(nested(R"([{"a":)", 100), 100U);
  EXPECT_EQ(nested(R"([{"a":)", 101), 0U);
  EXPECT_EQ(json_place(R"({"a": [[]], "b": )").objects.size(), 1U);
}

// Names that grow at each closed object would take gigabytes here, and minutes.
TEST(JsonPlace, TakesManyStringsOfObjectsThatAreClosed) {
  constexpr int depth = 199;
  std::string text = "{";
  for (int i = 1; i < depth; ++i) text += "\"" + std::string(1000, 'k') + "\":{";
  for (int i = 0; i < 50'000; ++i) text += "\"a" + std::to_string(i) + "\":\"b\",";
  for (int i = 1; i < depth; ++i) text += '}';
  const auto began = std::chrono::steady_clock::now();
  EXPECT_EQ(json_place(text + R"(,"name":"c","d":)").text("name"), "c");
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(60));
}

TEST(JsonPlace, TakesWhatIsNotRight) {
  for (const char* before :
       {"}}}]]", R"({]}{"a)", R"({"a" "b" "c" [}])", R"("\)", "{{{{[[[[", ","}) {
    json_place(before);
  }
}

}  // namespace
}  // namespace mjcourse
