// UTF-8: what the lesson language is written in.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

// Unicode code points in `text`, which is valid UTF-8.
int count_characters(std::string_view text);

// How many columns of a terminal `text` takes, which is valid UTF-8: two for an ideograph, none for
// an accent that goes onto the letter before it.
int count_columns(std::string_view text);

// The characters of `text`, which is valid UTF-8.
std::vector<std::string_view> characters_of(std::string_view text);

// Where the character begins that byte `at` of `text` belongs to; the end of `text` for its end.
std::size_t character_start(std::string_view text, std::size_t at);

// Where the character ends that byte `at` of `text` belongs to.
std::size_t character_end(std::string_view text, std::size_t at);

// The offset of the first byte that is not well-formed UTF-8 (RFC 3629: no overlong forms, no
// surrogates, nothing past U+10FFFF), or nothing when all of `text` is.
std::optional<std::size_t> find_invalid_utf8(std::string_view text);

// The offset of the first control character that no text holds: all but tabs, line feeds, and a
// carriage return before one or at the very end; or nothing. Those from U+0080 to U+009F have two
// bytes.
std::optional<std::size_t> find_control_character(std::string_view text);

// As ASCII has them: the user's language must not matter.
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
constexpr bool is_letter_or_digit(char c) {
  return is_letter(c) || is_digit(c);
}
// A letter, a digit or `_`, as regular expressions have them (`\w`).
constexpr bool is_word_character(char c) {
  return is_letter_or_digit(c) || c == '_';
}

// `text` as one line that any terminal shows, in the order it has. Control characters stand as C
// writes them (`\n`, `\x1b`), and so does what has a line turned round or broken (`\u202e`). U+FFFD
// stands for each byte that is not UTF-8.
std::string readable(std::string_view text);

// Unicode's name for the first character of `text`, "U+00A0".
std::string code_point_of(std::string_view text);

// A line of a program's or a tool's words, the same; but tabs stay where all else is readable.
std::string readable_output(std::string_view line);

// `line` with a blank for each tab and a `?` for each other character that readable() would write
// out, so that all others stay where they are.
std::string with_marks_for_unreadable(std::string_view line);

// UTF-16 as UTF-8, with U+FFFD for each half of a surrogate pair that stands alone.
std::string utf8_of(std::u16string_view text);

// `text`, which is valid UTF-8, in small letters, whatever the user's language: what matches
// whatever its case.
std::string lower_case_utf8(std::string_view text);

}  // namespace mjcourse
