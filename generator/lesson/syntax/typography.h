// Typography: what typed quotes, dashes and dots become in the page.
//
// Typed are `"`, `'`, `--`, `---` and `...`, as every keyboard has them. Which marks two quotes
// become is a matter of the page's language (course/quotation_marks.h); what is typed as it should
// look stays.
#pragma once

#include <string_view>

namespace mjcourse {

// Of `"` and, for what is quoted within that, of `'`.
struct QuotationMarks {
  std::string_view open, close, inner_open, inner_close;

  friend bool operator==(const QuotationMarks&, const QuotationMarks&) = default;
};

inline constexpr QuotationMarks kEnglishMarks{"“", "”", "‘", "’"};

struct Typography {
  bool smart = true;  // else all stays as it is typed
  QuotationMarks marks = kEnglishMarks;

  friend bool operator==(const Typography&, const Typography&) = default;
};

}  // namespace mjcourse
