#include "base/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace mjcourse {
namespace {

TEST(Utf8, CountsColumnsOfATerminal) {
  EXPECT_EQ(count_columns("abc"), 3);
  EXPECT_EQ(count_columns("é→𝄞"), 3);
  EXPECT_EQ(count_columns("中文"), 4);
  EXPECT_EQ(count_columns("e\u0301"), 1);  // an accent of its own
  EXPECT_EQ(count_columns("😀"), 2);
  EXPECT_EQ(count_columns(""), 0);
}

TEST(Utf8, CountsCodePoints) {
  EXPECT_EQ(count_characters(""), 0);
  EXPECT_EQ(count_characters("abc"), 3);
  EXPECT_EQ(count_characters("é→𝄞"), 3);
}

TEST(Utf8, IsTakenApartIntoCharacters) {
  EXPECT_EQ(characters_of("aé→𝄞"), (std::vector<std::string_view>{"a", "é", "→", "𝄞"}));
  EXPECT_TRUE(characters_of("").empty());
}

TEST(Utf8, HasTheLettersAndDigitsOfAscii) {
  std::string letters, digits, words;
  for (int c = -128; c < 128; ++c) {
    if (is_letter(static_cast<char>(c))) letters += static_cast<char>(c);
    if (is_digit(static_cast<char>(c))) digits += static_cast<char>(c);
    if (is_word_character(static_cast<char>(c))) words += static_cast<char>(c);
    EXPECT_EQ(is_letter_or_digit(static_cast<char>(c)),
              is_letter(static_cast<char>(c)) || is_digit(static_cast<char>(c)));
  }
  EXPECT_EQ(digits, "0123456789");
  EXPECT_EQ(letters, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz");
  EXPECT_EQ(words, "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ_abcdefghijklmnopqrstuvwxyz");
}

TEST(Utf8, AcceptsTheEdgesOfEveryLength) {
  for (const char* text :
       {"\x7F", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80",
        "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_EQ(find_invalid_utf8(text), std::nullopt) << text;
  }
  EXPECT_EQ(find_invalid_utf8(std::string_view("\0", 1)), std::nullopt);
}

TEST(Utf8, RefusesWhatRfc3629Refuses) {
  const std::pair<const char*, const char*> refused[] = {
      {"a lone continuation", "\x80"},
      {"an overlong slash in two bytes", "\xC0\xAF"},
      {"an overlong two-byte form", "\xC1\xBF"},
      {"an overlong three-byte form", "\xE0\x9F\xBF"},
      {"an overlong four-byte form", "\xF0\x8F\xBF\xBF"},
      {"the first surrogate", "\xED\xA0\x80"},
      {"the last surrogate", "\xED\xBF\xBF"},
      {"a character past U+10FFFF", "\xF4\x90\x80\x80"},
      {"a byte that begins nothing", "\xF5\x80\x80\x80"},
      {"a sequence cut short by the end", "\xE2\x82"},
      {"a sequence cut short by a letter", "\xE2\x82z"},
      {"Latin-1", "\xE9t\xE9"},
  };
  for (const auto& [what, bytes] : refused) {
    EXPECT_EQ(find_invalid_utf8(bytes), 0u) << what;
    EXPECT_EQ(find_invalid_utf8(std::string("é ") + bytes), 3u) << what << ", further on";
  }
}

TEST(Utf8, FindsControlCharactersButTabsAndLineEnds) {
  EXPECT_EQ(find_control_character("a\tb\r\nc\nü\r"), std::nullopt);
  EXPECT_EQ(find_control_character("a\rb"), 1u);
  EXPECT_EQ(find_control_character("a\r\rb"), 1u);
  EXPECT_EQ(find_control_character(std::string_view("ab\0", 3)), 2u);
  EXPECT_EQ(find_control_character("\x1b[31m"), 0u);
  EXPECT_EQ(find_control_character("é\x7F"), 2u);
  EXPECT_EQ(find_control_character("a\u00A0\u0085"), 3u);
}

TEST(Utf8, IsMadeReadableInOneLine) {
  EXPECT_EQ(readable("é→𝄞 \\n"), "é→𝄞 \\n");
  EXPECT_EQ(readable("a\nb\r\tc"), "a\\nb\\r\\tc");
  EXPECT_EQ(readable("\x1b[31m\x7F"), "\\x1b[31m\\x7f");
  EXPECT_EQ(readable(std::string("\0", 1)), "\\x00");
  EXPECT_EQ(readable("\u009B31m\u00A0\u0080"), "\\x9b31m\u00A0\\x80");
  EXPECT_EQ(readable("a\u202Eb\u2066c\u2069\u2028"), "a\\u202eb\\u2066c\\u2069\\u2028");
  EXPECT_EQ(readable("\u200Fא\u2027\u202F\u2065"), "\u200Fא\u2027\u202F\u2065");
  EXPECT_EQ(readable("\xC3 and \xF0\x9D"), "\uFFFD and \uFFFD\uFFFD");
}

TEST(Utf8, OfAProgramKeepsItsTabsWhereAllElseIsReadable) {
  EXPECT_EQ(readable_output("a\tb"), "a\tb");
  EXPECT_EQ(readable_output("a\tb\x1b"), "a\\tb\\x1b");
  EXPECT_EQ(readable_output("a\u2028b\u202E"), "a\\u2028b\\u202e");
}

TEST(Utf8, IsMarkedWhereItCannotBeRead) {
  EXPECT_EQ(with_marks_for_unreadable("é\t\x1b[\u009B\u202Ea\u2066"), "é ?[??a?");
}

TEST(Utf8, SmallLettersAreThoseOfEveryLanguage) {
  EXPECT_EQ(lower_case_utf8("Free JOINT 2"), "free joint 2");
  EXPECT_EQ(lower_case_utf8("ÉCOLE Straße ΩΜΕΓΑ ЖУК"), "école straße ωμεγα жук");
  EXPECT_EQ(lower_case_utf8("𝔘 漢字 𐐀"), "𝔘 漢字 𐐨");
  EXPECT_EQ(lower_case_utf8("ΛΟΓΟΣ, λόγος"), "λογος, λόγος");  // a sigma at a word's end
  EXPECT_EQ(lower_case_utf8(""), "");
}

TEST(Utf8, IsWholeWhateverUtf16Holds) {
  EXPECT_EQ(utf8_of(u"aé漢😀"), "aé漢😀");
  const char16_t high = 0xD83D, low = 0xDE00;
  EXPECT_EQ(utf8_of(std::u16string{high}), "\uFFFD");
  EXPECT_EQ(utf8_of(std::u16string{'a', low, high, 'b'}), "a\uFFFD\uFFFDb");
  EXPECT_EQ(utf8_of(std::u16string{high, high, low}), "\uFFFD😀");
}

TEST(Utf8, KnowsWhereACharacterEnds) {
  const std::string text = "a漢é𝄞";
  EXPECT_EQ(character_end(text, 0), 1u);
  for (const std::size_t at : {1u, 2u, 3u}) EXPECT_EQ(character_end(text, at), 4u);
  EXPECT_EQ(character_end(text, 4), 6u);
  EXPECT_EQ(character_end(text, 6), 10u);
}

TEST(Utf8, KnowsWhereACharacterBegins) {
  const std::string text = "a漢";
  EXPECT_EQ(character_start(text, 0), 0u);
  for (const std::size_t at : {1u, 2u, 3u}) EXPECT_EQ(character_start(text, at), 1u);
  for (const std::size_t at : {4u, 9u}) EXPECT_EQ(character_start(text, at), 4u);
}

}  // namespace
}  // namespace mjcourse
