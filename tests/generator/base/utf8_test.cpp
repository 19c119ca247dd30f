#include "base/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace mjcourse {
namespace {

TEST(Utf8, CountsCodePoints) {
  EXPECT_EQ(count_characters(""), 0);
  EXPECT_EQ(count_characters("abc"), 3);
  EXPECT_EQ(count_characters("é→𝄞"), 3);
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

TEST(Utf8, SmallLettersAreThoseOfEveryLanguage) {
  EXPECT_EQ(lower_case_utf8("Free JOINT 2"), "free joint 2");
  EXPECT_EQ(lower_case_utf8("ÉCOLE Straße ΩΜΕΓΑ ЖУК"), "école straße ωμεγα жук");
  EXPECT_EQ(lower_case_utf8("𝔘 漢字 𐐀"), "𝔘 漢字 𐐨");
}

}  // namespace
}  // namespace mjcourse
