#include "lesson/json/json_value.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

// JSON as it would stand in a file of its own.
struct Parsed {
  explicit Parsed(std::string text) : source("a.md", std::move(text)) {
    Reading reading(source, diagnostics);
    value = parse_json(located(source, {0, source.text().size()}), reading);
  }
  std::string mistakes() const { return shown(diagnostics); }
  // The text that `span` covers.
  std::string_view at(Span span) const {
    return source.text().substr(span.begin, span.end - span.begin);
  }
  // The same of the only member's value.
  std::string_view member() const { return at(value.value().members.at(0).value.span); }

  SourceText source;
  Diagnostics diagnostics;
  std::optional<JsonValue> value;
};

TEST(Json, KnowsWhereEachValueStands) {
  for (const std::string text : {"12", "-1.5e-3", "true", "false", "null", "\"a\"", "[]", "{}",
                                 "[1, [2, {\"b\": 3}]]", "{\"b\": [1, 2], \"c\": {}}"}) {
    EXPECT_EQ(Parsed("{\"a\": " + text + "}").member(), text);
    EXPECT_EQ(Parsed("{\"a\":" + text + "\n , \"b\": 0 }").member(), text);
    EXPECT_EQ(Parsed(text).at(Parsed(text).value.value().span), text);
  }
}

TEST(Json, KnowsWhereEachItemStands) {
  const Parsed parsed("[10,20 , \"x\",\n true,[ ]]");
  std::string items;
  for (const JsonValue& item : parsed.value->items)
    items += std::string(parsed.at(item.span)) + ";";
  EXPECT_EQ(items, "10;20;\"x\";true;[ ];");
}

TEST(Json, ReadsValues) {
  const Parsed parsed(R"({"n": -2.5, "b": true, "s": "é", "z": null, "big": 12345678901})");
  const auto& members = parsed.value->members;
  EXPECT_EQ(members[0].value.number, -2.5);
  EXPECT_TRUE(members[1].value.boolean);
  EXPECT_EQ(members[2].value.string.text, "é");
  EXPECT_EQ(members[3].value.kind, JsonValue::Kind::null);
  EXPECT_EQ(members[4].value.number, 12345678901.0);
}

// Each byte of a string with escapes, beside the text that it was written as.
TEST(Json, KnowsWhereEachByteOfAStringStood) {
  const Parsed parsed(R"({"k": "a\n\"\u00e9\ud834\udd1eé\\z"})");
  const LocatedText& text = parsed.value->members[0].value.string;
  EXPECT_EQ(text.text, "a\n\"é𝄞é\\z");
  const auto written = [&](std::string_view part) {
    const std::size_t at = text.text.find(part);
    return std::string(parsed.at(text.span(at, at + part.size())));
  };
  EXPECT_EQ(written("a"), "a");
  EXPECT_EQ(written("\n"), "\\n");
  EXPECT_EQ(written("\""), "\\\"");
  EXPECT_EQ(written("é"), "\\u00e9");
  EXPECT_EQ(written("𝄞"), "\\ud834\\udd1e");
  EXPECT_EQ(written("𝄞é"), "\\ud834\\udd1eé");
  EXPECT_EQ(written("\\"), "\\\\");
  EXPECT_EQ(written("z"), "z");
}

TEST(Json, FindsTheOpeningQuoteOfAStringFullOfThem) {
  EXPECT_EQ(Parsed(R"({"a": "\"\\\"\\"})").member(), R"("\"\\\"\\")");
}

TEST(Json, TakesEachKeyOnce) {
  const Parsed parsed("{\"a\": 1,\n \"\\u0061\": 2}");
  EXPECT_FALSE(parsed.value);
  EXPECT_EQ(parsed.mistakes(),
            "a.md:2:3: error: the key \"a\" stands twice [E-json-duplicate]\n"
            "  2 |  \"\\u0061\": 2}\n"
            "    |   ^~~~~~\n"
            "  cure: keep one of the two\n");
}

TEST(Json, TakesAKeyAgainInAnotherObject) {
  EXPECT_EQ(Parsed("{\"a\": {\"a\": 1}, \"b\": {\"a\": 2}}").mistakes(), "");
}

// The place, what it underlines and the message of the mistake in `text`.
std::string mistake(const std::string& text) {
  const Parsed parsed(text);
  EXPECT_FALSE(parsed.value) << text;
  if (parsed.diagnostics.size() != 1) return std::to_string(parsed.diagnostics.size());
  const Diagnostic& found = parsed.diagnostics[0];
  EXPECT_EQ(found.id, "E-json-syntax");
  const auto column = static_cast<std::size_t>(found.place.column - 1);
  return std::to_string(found.place.line) + ":" + std::to_string(column + 1) + " <" +
         found.place.excerpt.substr(column, static_cast<std::size_t>(found.place.width)) + "> " +
         found.message;
}

TEST(Json, ShowsWhatShouldNotBeThere) {
  EXPECT_EQ(mistake("{\"a\": 1\n \"bcd\": 2}"),
            "2:2 <\"bcd\"> this is not JSON: expected ',' or '}'");
  EXPECT_EQ(mistake("[1 22]"), "1:4 <22> this is not JSON: expected ',' or ']'");
  EXPECT_EQ(mistake("{\"a\": \"zoo\",}"), "1:13 <}> this is not JSON: expected string literal");
  EXPECT_EQ(mistake("{\"a\" 1}"), "1:6 <1> this is not JSON: expected ':'");
  EXPECT_EQ(mistake("{\"a\": 1} x"), "1:10 <x> this is not JSON: expected end of input");
  EXPECT_EQ(mistake("{\"a\": 'x'}"), "1:7 <'> this is not JSON: invalid literal");
  EXPECT_EQ(mistake("{\"a\": tru}"), "1:7 <tru> this is not JSON: invalid literal");
  EXPECT_EQ(mistake("// no"), "1:1 </> this is not JSON: invalid literal");
  EXPECT_EQ(mistake("[1e999]"), "1:2 <1e999> this number is too large");
}

TEST(Json, RefusesWholeNumbersOfWhichADoubleLosesDigits) {
  for (const std::string number :
       {"9007199254740992", "-9007199254740993", "123456789012345678901234567890"}) {
    const Parsed parsed("{\"a\": " + number + "}");
    EXPECT_FALSE(parsed.value);
    ASSERT_EQ(parsed.diagnostics.size(), 1u);
    const Diagnostic& found = parsed.diagnostics[0];
    EXPECT_EQ(found.id, "E-json-range");
    EXPECT_EQ(found.place.column, 7);
    EXPECT_EQ(found.place.width, static_cast<int>(number.size()));
    EXPECT_EQ(found.message, "whole numbers are exact below 2^53, and this one is not below");
    EXPECT_EQ(found.cure,
              "if its last digits do not matter, write it with an exponent, such as 1.2e16");
  }
  EXPECT_TRUE(Parsed("[9007199254740991, -9007199254740991, 9.007199254740993e15]").value);
}

// What was read as a literal ends before the quote, which need not be the second of two.
TEST(Json, ShowsALetterBeforeAQuote) {
  EXPECT_EQ(mistake("{t\"a\": 1}"), "1:2 <t> this is not JSON: expected string literal");
  EXPECT_EQ(mistake("{\"a\": u\"b\"}"), "1:7 <u> this is not JSON: invalid literal");
  EXPECT_EQ(mistake("[u\"b\"]"), "1:2 <u> this is not JSON: invalid literal");
}

TEST(Json, ShowsWhereTheTextEnds) {
  EXPECT_EQ(mistake("{\"a\": 1\n"),
            "2:1 <> this is not JSON: expected ',' or '}', but the text ends here");
  EXPECT_EQ(mistake(""),
            "1:1 <> this is not JSON: expected '[', '{', or a literal, but the text ends here");
}

TEST(Json, SaysWhatAStringCannotHold) {
  EXPECT_EQ(Parsed("{\"a\": \"b\nc\"}").mistakes(),
            "a.md:1:9: error: a JSON string cannot hold a raw line break or tab [E-json-syntax]\n"
            "  1 | {\"a\": \"b\n"
            "    |         ^\n"
            "  cure: write \\n, or give the script as a list of lines\n");
  EXPECT_EQ(
      Parsed("{\"a\": \"$\\alpha$\"}").mistakes(),
      "a.md:1:10: error: this is not JSON: invalid string: forbidden character after backslash "
      "[E-json-syntax]\n"
      "  1 | {\"a\": \"$\\alpha$\"}\n"
      "    |          ^\n"
      "  cure: in JSON a backslash is written twice: \\\\alpha\n");
}

TEST(Json, HasADepth) {
  const auto nested = [](std::size_t depth) {
    return Parsed(std::string(depth, '[') + std::string(depth, ']'));
  };
  EXPECT_TRUE(nested(200).value);
  EXPECT_EQ(nested(300'000).value, std::nullopt);
  EXPECT_EQ(nested(201).diagnostics.at(0).message,
            "lists and objects are nested here more than 200 deep");
  EXPECT_EQ(nested(201).diagnostics.at(0).place.column, 201);
}

}  // namespace
}  // namespace mjcourse
