#include "lesson/blocks/read_value.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

// "source|expression|format", each with where it stands.
std::string value(const std::string& body) {
  const ReadingOf reading = reading_of(body);
  std::string text = reading.mistakes();
  for (const Block& block : reading.lesson->blocks) {
    const auto* found = std::get_if<InlineValue>(&block);
    if (found == nullptr) continue;
    text += found->source.text + " " + reading.place(found->source) + "|" + found->expression.text +
            " " + reading.place(found->expression) + "|" + found->format.text + "\n";
  }
  return text;
}

TEST(Value, IsANameInBracesAndAnExpression) {
  EXPECT_EQ(value("a `{joint_zoo} model.nq` b\n"), "joint_zoo 4:5|model.nq 4:16|\n");
  EXPECT_EQ(value("`{l1_2-x.y}  naive_qz`\n"), "l1_2-x.y 4:3|naive_qz 4:14|\n");
  EXPECT_EQ(value("`{arm/scene} model.nq`\n"), "arm/scene 4:3|model.nq 4:14|\n");
  EXPECT_EQ(value("`{a} x` and `{a} x`\n"), "a 4:3|x 4:6|\na 4:15|x 4:18|\n");
}

TEST(Value, MayHaveAFormat) {
  EXPECT_EQ(value("`{a} x :.4f`\n"), "a 4:3|x 4:6|.4f\n");
  EXPECT_EQ(value("`{a} x :d`\n"), "a 4:3|x 4:6|d\n");
  EXPECT_EQ(value("`{a} x ? y :z`\n"), "a 4:3|x ? y :z 4:6|\n");
  EXPECT_EQ(value("`{a} x ? 1 : 2 :.17g`\n"), "a 4:3|x ? 1 : 2 4:6|.17g\n");
}

TEST(Value, StandsWhereverTextMay) {
  EXPECT_EQ(value("| a |\n|---|\n| `{a} x` |\n"), "a 6:5|x 6:8|\n");
  EXPECT_EQ(value("> [!note] Of `{a} x`\n> - `{b} y`\n"), "a 4:16|x 4:19|\nb 5:7|y 5:10|\n");
  EXPECT_EQ(
      value("```quiz\n{\"id\": \"q\", \"questions\": [{\"kind\": \"numeric\", \"answer\": 1,\n"
            "\"q\": \"\\u0041 `{a} x`\", \"explain\": \"`{b} y`\"}]}\n```\n"),
      "a 6:16|x 6:19|\nb 6:38|y 6:41|\n");
}

TEST(Value, IsNotEveryCodeThatBeginsWithABrace) {
  for (const std::string code : {"{x}", "{}", "{", "{x", "{1, 2}", "{0} x", "{ a } b", "{a, b}",
                                 "{return x;}", "{\"a\": 1}", "x {a} b", "{a/} b", "{/a} b"}) {
    EXPECT_EQ(value("`" + code + "`\n"), "") << code;
  }
  EXPECT_EQ(value("<code>{a} b</code>\n"), "");
}

// Each mistake: id, what it underlines, message, cure.
std::string wrong(const std::string& code) {
  std::string text;
  for (const Diagnostic& d : reading_of("`" + code + "`\n").diagnostics) {
    const auto column = static_cast<std::size_t>(d.place.column - 1);
    text += d.id + " <" + d.place.excerpt.substr(column, static_cast<std::size_t>(d.place.width)) +
            "> " + d.message + " | " + d.cure + "\n";
  }
  return text;
}

TEST(Value, ThatIsNearlyOneIsAMistake) {
  const std::string cure =
      " | a value is written `{joint_zoo} model.nq`; for code that looks like one write "
      "`<code>…</code>`\n";
  EXPECT_EQ(wrong("{a}x"), "E-value-form <}> a space is missing after the name in braces" + cure);
  EXPECT_EQ(wrong("{a x"), "E-value-form <{> this `{` is never closed" + cure);
  EXPECT_EQ(wrong("{a} :d"),
            "E-value-form <{a} :d> no expression follows the name in braces" + cure);
}

TEST(Value, RefusesAFormatThatPrintfHasNot) {
  const std::string cure = " | write `:d`, `:.4f`, `:.3e` or `:.6g`, with up to 17 digits\n";
  for (const std::string format : {":", ":.4", ":4f", ":x", ":.2d", ":.18f", ":s"}) {
    EXPECT_EQ(wrong("{a} x " + format),
              "E-value-format <" + format + "> `" + format + "` is not a number format" + cure);
  }
}

}  // namespace
}  // namespace mjcourse
