// A formula in plain text, for what takes no HTML: `x^2` is "x²", `\frac{a}{b+1}` is "a/(b + 1)".
#pragma once

#include <string>

namespace mjcourse {

// Of KaTeX's `markup`, which has the formula as MathML as well; "" where it does not.
std::string formula_text(const std::string& markup);

// May it be wider than a phone? Then its paragraph can be scrolled to the side (math.css).
bool is_wide_formula(const std::string& markup);

}  // namespace mjcourse
