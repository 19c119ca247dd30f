#include "lesson/syntax/doubtful_math.h"

#include <re2/re2.h>

#include <algorithm>

#include "base/utf8.h"

namespace mjcourse {

bool is_doubtful_math(char before, std::string_view tex, std::string_view behind) {
  // `H$_2$O`, `10$^{-3}$` and `5$\mu$m` are formulas that go on with a word.
  static const RE2 command(R"(\\[A-Za-z])", RE2::Latin1);
  // The $n$th row, three $x$s.
  static const RE2 ending(R"((th|st|nd|rd|s|es|d|fold)\b)", RE2::Latin1);
  static const RE2 word(R"([A-Za-z])", RE2::Latin1);
  // `$5 and more than 3$`
  static const RE2 money(R"(\d[\d.,]*[kKM]? [a-z]{2,} .*)", RE2::Latin1);
  // `$PATH; US$`
  static const RE2 words(R"([A-Za-z]{3,}[;,:.]? [A-Za-z]{2,}\b.*)", RE2::Latin1);
  const re2::StringPiece formula(tex.data(), tex.size());
  re2::StringPiece rest(behind.data(), behind.size());
  const bool is_tex =
      tex.starts_with('^') || tex.starts_with('_') || RE2::PartialMatch(formula, command);
  // $`x^2`$, which is a formula elsewhere; to KaTeX these are quotes.
  if (tex.size() > 1 && tex.starts_with('`') && tex.ends_with('`')) return true;
  if (is_tex) return false;
  if (RE2::FullMatch(formula, words)) return true;
  if (RE2::FullMatch(formula, money)) return true;
  // `US$5–$7; (5$ each)`. Half an interval, `$[0, 1)$`, begins with its bracket.
  const bool begins_with_digit = !tex.empty() && is_digit(tex[0]);
  if (begins_with_digit && std::ranges::count(tex, '(') != std::ranges::count(tex, ')'))
    return true;
  if (is_letter_or_digit(before)) return true;
  const bool ends_in_word = RE2::Consume(&rest, word);
  rest.set(behind.data(), behind.size());
  return ends_in_word && !RE2::Consume(&rest, ending);
}

}  // namespace mjcourse
