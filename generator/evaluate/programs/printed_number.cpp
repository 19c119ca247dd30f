#include "evaluate/programs/printed_number.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "base/utf8.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostExponentDigits = 3;  // no double has more
constexpr std::string_view kMinus = "\u2212";

bool is_name_letter(char c) {
  return is_word_character(c) && !is_digit(c);
}

// The character at `at`, and a space outside of `line`.
char character_at(std::string_view line, std::size_t at) {
  return at < line.size() ? line[at] : ' ';
}

std::string_view digits_at(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && is_digit(text[end])) ++end;
  return text.substr(at, end - at);
}

// How many bytes the sign at the start of `text` has.
std::size_t sign_length(std::string_view text) {
  if (text.starts_with(kMinus)) return kMinus.size();
  return text.starts_with('-') || text.starts_with('+') ? 1 : 0;
}

// Of an exponent at the start of `text`: e-9, E+03, e5. Nothing when none is there.
std::string_view exponent_at(std::string_view text) {
  if (!text.starts_with('e') && !text.starts_with('E')) return {};
  const bool has_sign = character_at(text, 1) == '-' || character_at(text, 1) == '+';
  const std::string_view digits = digits_at(text, has_sign ? 2 : 1);
  if (digits.empty() || digits.size() > kMostExponentDigits) return {};
  return text.substr(0, digits.size() + (has_sign ? 2 : 1));
}

// Digits, a point, and digits: 0.5.
bool decimals_at(std::string_view text, std::size_t at) {
  const std::size_t point = at + digits_at(text, at).size();
  return point > at && character_at(text, point) == '.' && is_digit(character_at(text, point + 1));
}

// Do the digits that end before `end` have a point in front of them?
bool decimals_before(std::string_view line, std::size_t end) {
  while (end > 0 && is_digit(line[end - 1])) --end;
  return end > 1 && line[end - 1] == '.' && is_digit(line[end - 2]);
}

// Does the word "version" stand before `begin`, as in "OpenGL version: 4.5"?
bool is_version(std::string_view line, std::size_t begin) {
  constexpr std::string_view word = "version";
  const std::size_t last = line.substr(0, begin).find_last_not_of(" :=");
  if (last == line.npos || last + 1 == begin || last + 1 < word.size()) return false;
  const std::string_view before = line.substr(0, last + 1 - word.size());
  const std::string_view written = line.substr(before.size(), word.size());
  return (before.empty() || !is_word_character(before.back())) &&
         std::equal(written.begin(), written.end(), word.begin(), word.end(),
                    [](char a, char b) { return (a | 0x20) == b; });
}

// Is what begins at `begin` a part of what stands before it? x1, 2.2.2, l-1.5, lib/1.5, 12:30.5.
bool goes_on_before(std::string_view line, std::size_t begin) {
  if (begin == 0) return false;
  const char before = line[begin - 1];
  if (is_word_character(before) || before == '.') return true;
  const char first = begin > 1 ? line[begin - 2] : ' ';
  if (before == ':') return is_digit(first);
  if (before == '~') return is_word_character(first);
  if (std::string_view("-+/@").find(before) == std::string_view::npos) return false;
  // 0.1-0.2 is a range, and 0.5-0.1i a complex number; 12-14 is neither's.
  const bool has_decimals = decimals_at(line, begin) || line[begin] == '.';
  return is_name_letter(first) ||
         (before == '-' && is_digit(first) && !(has_decimals && decimals_before(line, begin - 1)));
}

// Is what ends before `end` a part of what stands behind it? 2.2.2, 1e5f7, 12.2-14, 12:30, 1.0+git.
// Letters behind it are its unit. `decimals`: it has digits behind its point.
bool goes_on_behind(std::string_view line, std::size_t end, bool decimals) {
  while (is_name_letter(character_at(line, end)) && line[end] != '_') ++end;
  const char behind = character_at(line, end), next = character_at(line, end + 1);
  if (is_word_character(behind)) return true;
  switch (behind) {
    case '.':
    case '~':
      return is_word_character(next);
    case ':':
      return is_digit(next);
    case '+':
    case '@':
      return is_name_letter(next);
    case '-':
      return is_word_character(next) && !(decimals && decimals_at(line, end + 1));
    default:
      return false;
  }
}

}  // namespace

std::optional<PrintedNumber> PrintedNumber::read(std::string_view text) {
  PrintedNumber number;
  std::size_t at = sign_length(text);
  number.negative_ = at > 0 && !text.starts_with('+');
  number.whole_ = digits_at(text, at);
  at += number.whole_.size();
  if (character_at(text, at) == '.') number.fraction_ = digits_at(text, at + 1);
  if (!number.fraction_.empty()) at += 1 + number.fraction_.size();
  if (number.whole_.empty() && number.fraction_.empty()) return std::nullopt;
  // 1.e-05, as some print it; any other point without digits ends a sentence.
  const bool bare_point = number.fraction_.empty() && character_at(text, at) == '.';
  std::string_view exponent =
      exponent_at(text.substr(std::min(at + (bare_point ? 1 : 0), text.size())));
  if (!exponent.empty()) {
    at += exponent.size() + (bare_point ? 1 : 0);
    exponent.remove_prefix(1);
  }
  number.exponent_ = exponent;
  number.length_ = at;
  return number;
}

std::optional<PrintedNumber> PrintedNumber::find(std::string_view line, std::size_t at) {
  const char first = character_at(line, at);
  if (!is_digit(first) && first != '.' && sign_length(line.substr(at)) == 0) return std::nullopt;
  if (goes_on_before(line, at) || is_version(line, at)) return std::nullopt;
  const std::optional<PrintedNumber> number = read(line.substr(at));
  if (!number || goes_on_behind(line, at + number->length_, !number->fraction_.empty())) {
    return std::nullopt;
  }
  return number;
}

// Has it a last place that may have been rounded? A count has none, nor has 1e5, which may as well
// be the beginning of a hash.
bool PrintedNumber::shows_place() const {
  return !fraction_.empty() || exponent_.starts_with('-') || exponent_.starts_with('+');
}

bool PrintedNumber::is_zero() const {
  return whole_.find_first_not_of('0') == whole_.npos &&
         fraction_.find_first_not_of('0') == fraction_.npos;
}

Decimal PrintedNumber::value() const {
  int exponent = 0;
  const std::string_view digits = exponent_.substr(exponent_.starts_with('+') ? 1 : 0);
  std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  return {negative_, std::string(whole_) + std::string(fraction_), static_cast<int>(whole_.size()),
          exponent};
}

bool PrintedNumber::agrees_with(const PrintedNumber& real,
                                const std::optional<Decimal>& tolerance) const {
  if (tolerance || shows_place() || real.shows_place()) {
    const Decimal stated = value();
    const Decimal unit = shows_place() ? Decimal::unit_of(stated) : Decimal(false, "0", 1, 0);
    return Decimal::within(stated, real.value(), tolerance.value_or(unit));
  }
  // 007 is not 7, and 0e1 not 0e2: what leaves no room is the same text, but for the sign of 0.
  return whole_ == real.whole_ && exponent_ == real.exponent_ &&
         (negative_ == real.negative_ || is_zero());
}

}  // namespace mjcourse
