#include "lsp/json_place.h"

#include <gtest/gtest.h>

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
  EXPECT_EQ(json_place(R"({"data": {"name": "a/b"}, "mark": )").text("data.name"), "a/b");
  EXPECT_EQ(json_place(R"({"layer": [{"name": "c"}], "mark": )").text("layer.name"), "");
}

TEST(JsonPlace, CountsListsWithinAnObject) {
  const JsonPlace place = json_place(R"({"a": [[{"b": [)");
  EXPECT_EQ(place.objects[0].lists, 0);
  EXPECT_EQ(place.objects[1].lists, 2);
  EXPECT_EQ(place.lists, 1);
  EXPECT_EQ(json_place(R"({"a": [1, 2], "b": )").lists, 0);
}

TEST(JsonPlace, TakesWhatIsNotRight) {
  for (const char* before :
       {"}}}]]", R"({]}{"a)", R"({"a" "b" "c" [}])", R"("\)", "{{{{[[[[", ","}) {
    json_place(before);
  }
}

}  // namespace
}  // namespace mjcourse
