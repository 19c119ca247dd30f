#include "toolchain/raw_tokens.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// Those that are no blanks, each as its kind and its text.
std::vector<std::string> tokens_of(const std::string& text) {
  const auto all = raw_tokens({text}, Toolchain::find().value());
  if (!all) return {all.error()};
  std::vector<std::string> shown;
  for (const RawToken& token : all->front()) {
    const std::string_view words = token.in(text);
    if (words.find_first_not_of(" \t\n") == words.npos) continue;
    shown.push_back(token.kind + " " + std::string(words));
  }
  return shown;
}

using Shown = std::vector<std::string>;

TEST(RawTokens, AreAllOfAText) {
  const std::string text = "int main() {  // one\n  return 1'0;\n}\n";
  const auto all = raw_tokens({text, "", "x\n"}, Toolchain::find().value());
  ASSERT_TRUE(all) << all.error();
  std::string whole;
  for (const RawToken& token : (*all)[0]) whole += token.in(text);
  EXPECT_EQ(whole, text);
  EXPECT_TRUE((*all)[1].empty());
  EXPECT_EQ((*all)[2][0].in("x\n"), "x");
}

TEST(RawTokens, EndWhereTheCompilerEndsThem) {
  EXPECT_EQ(tokens_of("a\\\nb \"c\\\"d\" 'e' // f \\\ng\n/* h\n// */ i\n"),
            (Shown{"raw_identifier a\\\nb", "string_literal \"c\\\"d\"", "char_constant 'e'",
                   "comment // f \\\ng", "comment /* h\n// */", "raw_identifier i"}));
  EXPECT_EQ(tokens_of("u8\\\nR\"x(\n)\" \")x\" j\n"),
            (Shown{"utf8_string_literal u8\\\nR\"x(\n)\" \")x\"", "raw_identifier j"}));
  EXPECT_EQ(tokens_of("\u00e41'2\n"), (Shown{"raw_identifier \u00e41", "unknown '2"}));
}

TEST(RawTokens, AreNotMistakenForTheListOfThem) {
  const std::string comment =
      "/*\nraw_identifier 'x'\t\tLoc=<0.cpp:1:1>\nhash '#'\t [StartOfLine]\tLoc=<a:1:1>\n*/";
  EXPECT_EQ(tokens_of(comment + "\n"), (Shown{"comment " + comment}));
}

TEST(RawTokens, NeedClang) {
  Toolchain toolchain = Toolchain::find().value();
  toolchain.compiler = "g++";
  toolchain.version = "g++ 12.2.0";
  EXPECT_EQ(raw_tokens({"x\n"}, toolchain).error(),
            "only clang tells the tokens of a text, and the compiler here is g++ 12.2.0");
}

}  // namespace
}  // namespace mjcourse
