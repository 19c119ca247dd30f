#include "evaluate/output_diff.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "base/text_lines.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

std::string_view trimmed_right(std::string_view text) {
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  return text.substr(0, last == text.npos ? 0 : last + 1);
}

// `text` from its first character that is no space.
std::string_view without_spaces(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

std::vector<std::string_view> split_lines(std::string_view text) {
  std::vector<std::string_view> lines = lines_of(trimmed_right(text));
  for (std::string_view& line : lines) line = trimmed_right(line);
  return lines;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// The length of the number at the start of `text`: 12, -0.5, 1e-9, 2. ; 0 when there is none.
std::size_t number_length(std::string_view text) {
  std::size_t at = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  int digits = 0;
  for (bool point = false; at < text.size(); ++at) {
    if (is_digit(text[at])) {
      ++digits;
    } else if (text[at] == '.' && !point) {
      point = true;
    } else {
      break;
    }
  }
  if (digits == 0) return 0;
  std::size_t exponent = at;
  if (exponent < text.size() && (text[exponent] == 'e' || text[exponent] == 'E')) {
    ++exponent;
    if (exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+')) ++exponent;
    while (exponent < text.size() && is_digit(text[exponent])) at = ++exponent;
  }
  return at;
}

// One unit in the last place that `number` prints: 0.25 → 0.01, 3e-7 → 1e-7; 0 for a count.
double last_place(std::string_view number) {
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  const std::size_t point = number.substr(0, e).find('.');
  const std::size_t digits = point == number.npos ? 0 : e - point - 1;
  if (digits == 0 && e == number.size()) return 0;
  const int exponent = e < number.size() ? std::atoi(std::string(number.substr(e + 1)).c_str()) : 0;
  return std::pow(10.0, exponent - static_cast<int>(digits));
}

bool numbers_agree(std::string_view stated, std::string_view real,
                   std::optional<double> tolerance) {
  if (stated == real) return true;  // 1e999 is no number that could be subtracted
  const double a = std::strtod(std::string(stated).c_str(), nullptr);
  const double b = std::strtod(std::string(real).c_str(), nullptr);
  const double allowed = tolerance.value_or(last_place(stated));
  // The printed decimals are not exact in binary: 0.1 and 0.2 are one unit apart, and a hair.
  return std::abs(a - b) <= allowed * (1 + 1e-9) + 1e-12 * std::abs(a) * (allowed > 0 ? 1 : 0);
}

// Walks a stated line beside the real one.
class LineMatch {
 public:
  LineMatch(std::string_view stated, std::string_view real, std::optional<double> tolerance)
      : stated_(stated), real_(real), tolerance_(tolerance) {}

  bool agrees() {
    while (!stated_.empty() || !real_.empty()) {
      if (stated_.starts_with("[..]")) {
        stated_.remove_prefix(4);
        after_gap_ = stated_;
        gap_ = real_;
        after_word_ = false;
      } else if (!step() && !widen_gap()) {
        return false;
      }
    }
    return true;
  }

 private:
  // Take what agrees next from both; false when nothing does.
  bool step() {
    if (stated_.empty() || real_.empty()) return false;
    // A column of numbers may shift by a sign or a digit: any space matches any space, and none
    // where only the first column shifts (" 0.1" and "-0.0").
    const std::string_view stated_word = without_spaces(stated_), real_word = without_spaces(real_);
    const bool spaces = stated_[0] == ' ' || real_[0] == ' ';
    const bool first_column =
        !after_word_ && number_length(stated_word) > 0 && number_length(real_word) > 0;
    if (spaces && (stated_[0] == real_[0] || first_column)) {
      stated_ = stated_word;
      real_ = real_word;
      after_word_ = false;
      return true;
    }
    // Digits inside a word (l1_2) are letters, not numbers.
    const std::size_t stated_number = after_word_ ? 0 : number_length(stated_);
    const std::size_t real_number = after_word_ ? 0 : number_length(real_);
    if (stated_number > 0 && real_number > 0) {
      if (!numbers_agree(stated_.substr(0, stated_number), real_.substr(0, real_number),
                         tolerance_)) {
        return false;
      }
      stated_.remove_prefix(stated_number);
      real_.remove_prefix(real_number);
      after_word_ = true;
      return true;
    }
    if (stated_[0] != real_[0]) return false;
    after_word_ = is_word_character(stated_[0]);
    stated_.remove_prefix(1);
    real_.remove_prefix(1);
    return true;
  }

  // Let the last `[..]` stand for one character more, and try again behind it.
  bool widen_gap() {
    if (!after_gap_ || gap_.empty()) return false;
    gap_.remove_prefix(1);
    stated_ = *after_gap_;
    real_ = gap_;
    after_word_ = false;
    return true;
  }

  std::string_view stated_, real_;
  std::optional<double> tolerance_;
  bool after_word_ = false;
  std::optional<std::string_view> after_gap_;  // what the lesson states behind the last `[..]`
  std::string_view gap_;                       // the real text from where that `[..]` ends
};

}  // namespace

bool lines_agree(std::string_view stated, std::string_view real, std::optional<double> tolerance) {
  return LineMatch(trimmed_right(stated), trimmed_right(real), tolerance).agrees();
}

std::vector<DiffLine> output_changes(std::string_view stated, std::string_view real,
                                     std::optional<double> tolerance) {
  return line_diff(
      split_lines(stated), split_lines(real),
      [&](std::string_view a, std::string_view b) { return lines_agree(a, b, tolerance); });
}

}  // namespace mjcourse
