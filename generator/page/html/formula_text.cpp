#include "page/html/formula_text.h"

#include <re2/re2.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "base/text_lines.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

using tinyxml2::XMLElement;
using tinyxml2::XMLNode;
using Letters = std::map<std::string, std::string, std::less<>>;

const Letters& superscripts() {
  static const Letters letters{{"0", "⁰"}, {"1", "¹"}, {"2", "²"}, {"3", "³"}, {"4", "⁴"},
                               {"5", "⁵"}, {"6", "⁶"}, {"7", "⁷"}, {"8", "⁸"}, {"9", "⁹"},
                               {"+", "⁺"}, {"−", "⁻"}, {"=", "⁼"}, {"(", "⁽"}, {")", "⁾"},
                               {"n", "ⁿ"}, {"i", "ⁱ"}, {"T", "ᵀ"}, {"⊤", "ᵀ"}, {"′", "′"}};
  return letters;
}

const Letters& subscripts() {
  static const Letters letters{
      {"0", "₀"}, {"1", "₁"}, {"2", "₂"}, {"3", "₃"}, {"4", "₄"}, {"5", "₅"}, {"6", "₆"},
      {"7", "₇"}, {"8", "₈"}, {"9", "₉"}, {"+", "₊"}, {"−", "₋"}, {"=", "₌"}, {"(", "₍"},
      {")", "₎"}, {"a", "ₐ"}, {"e", "ₑ"}, {"o", "ₒ"}, {"x", "ₓ"}, {"h", "ₕ"}, {"k", "ₖ"},
      {"l", "ₗ"}, {"m", "ₘ"}, {"n", "ₙ"}, {"p", "ₚ"}, {"s", "ₛ"}, {"t", "ₜ"}, {"i", "ᵢ"},
      {"r", "ᵣ"}, {"u", "ᵤ"}, {"v", "ᵥ"}, {"j", "ⱼ"}};
  return letters;
}

// What stands over a letter, as a character that goes onto the one before it.
const Letters& accents() {
  static const Letters letters{{"˙", "\u0307"}, {"¨", "\u0308"}, {"^", "\u0302"},
                               {"~", "\u0303"}, {"ˉ", "\u0304"}, {"‾", "\u0304"},
                               {"⃗", "\u20D7"},  {"→", "\u20D7"}, {"ˇ", "\u030C"}};
  return letters;
}

bool is_among(std::string_view sign, const auto& signs) {
  return std::ranges::find(signs, sign) != signs.end();
}

// With a blank on both sides; these only where something stands before them.
constexpr std::array<std::string_view, 20> kRelations{"=", "≠", "<", ">", "≤", "≥", "≈",
                                                      "≡", "∼", "∝", "→", "←", "⇒", "⇔",
                                                      "↦", "∈", "∉", "≪", "≫", "≔"};
constexpr std::array<std::string_view, 9> kOperators{"+", "−", "±", "×", "⋅", "∘", "∧", "∨", "∖"};

// In parentheses where it is more than a word.
std::string grouped(const std::string& text) {
  return text.find(' ') == text.npos ? text : "(" + text + ")";
}

// `text` in these letters, or behind `mark` where one of its characters is none of them.
std::string raised(const std::string& text, const Letters& letters, const std::string& mark) {
  std::string written;
  for (const std::string_view character : characters_of(text)) {
    if (character == " ") continue;
    const auto letter = letters.find(std::string(character));
    if (letter == letters.end()) return mark + grouped(text);
    written += letter->second;
  }
  return written;
}

class LinearMath {
 public:
  std::string of(const XMLNode* node) const {
    if (node == nullptr) return "";
    if (const auto* text = node->ToText()) return text->Value();
    const XMLElement* element = node->ToElement();
    if (element == nullptr) return "";
    const std::string_view name = element->Name();
    if (name == "annotation") return "";
    if (name == "mspace") return " ";
    if (name == "mfrac") return grouped(child(element, 0)) + "/" + grouped(child(element, 1));
    if (name == "msqrt") return "√" + grouped(row(element));
    if (name == "mroot")
      return raised(child(element, 1), superscripts(), "") + "√" + grouped(child(element, 0));
    if (name == "msup") return child(element, 0) + above(element, 1);
    if (name == "msub") return child(element, 0) + below(element, 1);
    if (name == "msubsup" || name == "munderover") {
      return child(element, 0) + below(element, 1) + above(element, 2);
    }
    if (name == "munder") return child(element, 0) + below(element, 1);
    if (name == "mover") return accented(element);
    if (name == "mtable") return joined(element, "; ");
    if (name == "mtr") return joined(element, ", ");
    return row(element);
  }

 private:
  static const XMLNode* nth(const XMLElement* element, int index) {
    const XMLNode* node = element->FirstChild();
    while (node != nullptr && index-- > 0) node = node->NextSibling();
    return node;
  }
  std::string child(const XMLElement* element, int index) const {
    return std::string(trimmed(of(nth(element, index))));
  }
  std::string above(const XMLElement* element, int index) const {
    return raised(child(element, index), superscripts(), "^");
  }
  std::string below(const XMLElement* element, int index) const {
    return raised(child(element, index), subscripts(), "_");
  }

  std::string accented(const XMLElement* element) const {
    const std::string base = child(element, 0), over = child(element, 1);
    const auto accent = accents().find(over);
    if (accent == accents().end()) return base + raised(over, superscripts(), "^");
    return characters_of(base).size() == 1 ? base + accent->second : base;
  }

  std::string joined(const XMLElement* element, const char* between) const {
    std::string text;
    for (const XMLNode* one = element->FirstChild(); one != nullptr; one = one->NextSibling()) {
      if (!text.empty()) text += between;
      text += trimmed(of(one));
    }
    return text;
  }

  std::string row(const XMLElement* element) const {
    std::string text;
    for (const XMLNode* one = element->FirstChild(); one != nullptr; one = one->NextSibling()) {
      const std::string said = of(one);
      const bool is_sign = one->ToElement() != nullptr && one->ToElement()->Name() == kSign;
      const bool is_first = text.empty() || text.ends_with(' ') || text.ends_with('(');
      const bool spaced =
          is_sign && (is_among(said, kRelations) || (!is_first && is_among(said, kOperators)));
      text += spaced ? " " + said + " " : is_sign && said == "," ? ", " : said;
    }
    return text;
  }

  static constexpr std::string_view kSign = "mo";
};

// Without the characters that only tell what is applied to what.
std::string without_invisible(std::string text) {
  for (const std::string invisible : {"\u2062", "\u2063", "\u200B"}) {
    for (std::size_t at = 0; (at = text.find(invisible, at)) != text.npos;) {
      text.erase(at, invisible.size());
    }
  }
  for (const std::string blank : {"\u2061", "\u00A0", "\u2009", "\u2003", "\u205F"}) {
    for (std::size_t at = 0; (at = text.find(blank, at)) != text.npos;) {
      text.replace(at, blank.size(), " ");
    }
  }
  return text;
}

// What `\hspace` and `\quad` leave, in characters of half an em.
int room_in(const std::string& markup) {
  static const RE2 form(R"re(<mspace width="([\d.]+)em")re");
  re2::StringPiece rest(markup);
  double width = 0, room = 0;
  while (RE2::FindAndConsume(&rest, form, &width)) room += 2 * width;
  return static_cast<int>(std::min(room, 1000.0));
}

constexpr int kMostOnAPhone = 24;  // characters; mostly a line ends within a longer formula, too

}  // namespace

bool is_wide_formula(const std::string& markup) {
  return count_characters(formula_text(markup)) + room_in(markup) > kMostOnAPhone;
}

std::string formula_text(const std::string& markup) {
  const std::string_view end = "</math>";
  const std::size_t from = markup.find("<math"), to = markup.find(end);
  if (from == markup.npos || to == markup.npos) return "";
  tinyxml2::XMLDocument document;
  if (document.Parse(markup.data() + from, to + end.size() - from) != tinyxml2::XML_SUCCESS) {
    return "";
  }
  return std::string(trimmed(without_invisible(LinearMath().of(document.RootElement()))));
}

}  // namespace mjcourse
