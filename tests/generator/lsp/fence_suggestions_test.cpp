#include "lsp/fence_suggestions.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

std::string names(const Suggestions& found) {
  std::string all;
  for (const Suggestion& one : found.all) all += one.name + "|";
  return all;
}

std::string options(const std::string& info) {
  Suggestions found;
  add_options(found, info);
  return names(found);
}

std::string choices(const std::string& info) {
  Suggestions found;
  add_choices(found, info);
  return names(found);
}

TEST(FenceSuggestions, AreKindsWithWhatTheyNeed) {
  Suggestions found;
  add_fences(found);
  EXPECT_EQ(names(found),
            "cpp file=|cpp exercise file=|cpp snippet model=|sh run|xml model=|xml "
            "mjcf|text|io|lab simlab|quiz|figure|plot|"
            "demo|sh unchecked because=|cmake unchecked because=|python unchecked because=|"
            "yaml unchecked because=|json unchecked because=|markdown unchecked because=|"
            "cpp unchecked because=|xml unchecked because=|text unchecked because=|");
}

TEST(FenceSuggestions, AreTheWordsAndOptionsOfAKind) {
  EXPECT_EQ(options("lab "), "simlab|");
  EXPECT_EQ(options("xml "), "mjcf|unchecked|model=|");
  EXPECT_EQ(options("cpp snippet "), "model=|timeout=|native|because=|");
  EXPECT_EQ(options("python unchecked "), "because=|");
  EXPECT_EQ(options("poem "), "");
}

TEST(FenceSuggestions, AreNotWhatIsThereAlready) {
  EXPECT_EQ(options("cpp file=examples/a.cpp optimize "),
            "timeout=|expect=|args=|native|because=|");
  EXPECT_EQ(options("cpp file=examples/a.cpp#part "), "");
  EXPECT_EQ(options("cpp exercise file=examples/a.cpp#part "),
            "hidden=|timeout=|args=|optimize|native|because=|");
}

TEST(FenceSuggestions, AreTheValuesOfAnOption) {
  EXPECT_EQ(choices("cpp file=examples/a.cpp expect"), "exit:1|compile-error|");
  EXPECT_EQ(choices("xml mjcf expect"), "error|");
  EXPECT_EQ(choices("text tol"), "");
}

}  // namespace
}  // namespace mjcourse
