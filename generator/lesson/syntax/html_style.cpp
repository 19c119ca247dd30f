#include "lesson/syntax/html_style.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/nearest.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

constexpr std::array kProperties{
    "align-content",
    "align-items",
    "align-self",
    "aspect-ratio",
    "background-color",
    "border",
    "border-bottom",
    "border-color",
    "border-left",
    "border-radius",
    "border-right",
    "border-style",
    "border-top",
    "border-width",
    "break-inside",
    "color",
    "column-count",
    "column-gap",
    "columns",
    "display",
    "flex",
    "flex-basis",
    "flex-direction",
    "flex-grow",
    "flex-shrink",
    "flex-wrap",
    "font-size",
    "font-style",
    "font-variant",
    "font-weight",
    "gap",
    "grid-column",
    "grid-row",
    "grid-template-columns",
    "grid-template-rows",
    "height",
    "justify-content",
    "justify-items",
    "justify-self",
    "letter-spacing",
    "line-height",
    "list-style-type",
    "margin",
    "margin-bottom",
    "margin-left",
    "margin-right",
    "margin-top",
    "max-height",
    "max-width",
    "min-height",
    "min-width",
    "overflow",
    "overflow-x",
    "overflow-y",
    "padding",
    "padding-bottom",
    "padding-left",
    "padding-right",
    "padding-top",
    "row-gap",
    "text-align",
    "text-decoration",
    "text-indent",
    "vertical-align",
    "white-space",
    "width",
    "word-break",
};

constexpr std::array kFunctions{"calc", "clamp",  "fit-content", "hsl", "max",
                                "min",  "minmax", "repeat",      "rgb", "var"};

constexpr const char* kPlain = "name colours and lengths by words and numbers";

bool is_ident(char c) {
  return is_letter_or_digit(c) || c == '-';
}

// Nothing that begins a text, an escape, a comment, a rule or an address.
bool stands_in_value(char c) {
  return is_ident(c) || std::string_view(" \n.,%#()+*/").find(c) != std::string_view::npos;
}

std::optional<StyleFault> value_fault(std::string_view value, std::size_t begin) {
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!stands_in_value(value[i]) || value.substr(i).starts_with("/*")) {
      return StyleFault{begin + i, begin + i + 1, "a lesson's style cannot have this character",
                        kPlain};
    }
    if (value[i] != '(') continue;
    std::size_t name = i;
    while (name > 0 && is_ident(value[name - 1])) --name;
    const std::string function(value.substr(name, i - name));
    const bool known = function.empty() || std::find(kFunctions.begin(), kFunctions.end(),
                                                     function) != kFunctions.end();
    if (known) continue;
    return StyleFault{begin + name, begin + i, "a lesson's style cannot have `" + function + "()`",
                      kPlain};
  }
  const auto open = std::count(value.begin(), value.end(), '(');
  if (open == std::count(value.begin(), value.end(), ')')) return std::nullopt;
  return StyleFault{begin, begin + value.size(), "a bracket of this style has no partner",
                    "close each that is opened"};
}

}  // namespace

std::optional<StyleFault> style_fault(std::string_view style) {
  for (std::size_t at = 0; at < style.size();) {
    const std::size_t end = std::min(style.find(';', at), style.size());
    const std::size_t begin = std::min(style.find_first_not_of(" \n", at), style.size());
    at = end + 1;
    if (begin >= end) continue;
    const std::size_t colon = std::min(style.find(':', begin), end);
    std::string property(style.substr(begin, colon - begin));
    while (property.ends_with(' ')) property.pop_back();
    if (std::find(kProperties.begin(), kProperties.end(), property) == kProperties.end()) {
      return StyleFault{begin, begin + std::max<std::size_t>(property.size(), 1),
                        "a lesson's style cannot have `" + property + "`",
                        suggest(property, {kProperties.begin(), kProperties.end()})};
    }
    const std::size_t value = std::min(colon + 1, end);
    if (auto fault = value_fault(style.substr(value, end - value), value)) return fault;
  }
  return std::nullopt;
}

}  // namespace mjcourse
