#include "evaluate/scenes/svg_faults.h"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "base/utf8.h"
#include "evaluate/scenes/svg_bounds.h"
#include "evaluate/scenes/svg_names.h"

namespace mjcourse {
namespace {

using tinyxml2::XMLAttribute;
using tinyxml2::XMLElement;
using tinyxml2::XMLNode;

constexpr const char* kPlain =
    "use only elements that draw; most programs can save a \"plain\" SVG, which has nothing else";

constexpr std::size_t kMostFaults = 100;

// What of CSS and of presentation attributes does not compute from numbers.
constexpr std::array kFunctions{
    "calc",  "clamp",     "cubic-bezier", "first-child", "hsl",  "hsla",        "matrix", "max",
    "min",   "not",       "nth-child",    "rgb",         "rgba", "rotate",      "scale",  "skewX",
    "skewY", "translate", "translateX",   "translateY",  "var",  "drop-shadow", "blur"};

bool is_ident(char c) {
  return is_letter_or_digit(c) || c == '-';
}

// Why this CSS may lead out of the drawing; "" where it cannot.
std::string css_trouble(std::string_view css) {
  for (std::size_t i = 0; i < css.size(); ++i) {
    if (css[i] == '\\') return "an escape in its style";
    if (css[i] == '@') return "a rule with `@` in its style";
    if (css[i] != '(') continue;
    std::size_t begin = i;
    while (begin > 0 && is_ident(css[begin - 1])) --begin;
    const std::string_view function = css.substr(begin, i - begin);
    if (function.empty()) continue;
    if (function == "url") {
      const std::size_t target = css.find_first_not_of(" \"'", i + 1);
      if (target < css.size() && css[target] == '#') continue;
      return "an address outside of it";
    }
    if (std::find(kFunctions.begin(), kFunctions.end(), function) == kFunctions.end()) {
      return "the function `" + std::string(function) + "()` in its style";
    }
  }
  return "";
}

// A picture in the drawing itself, in a kind that holds no script.
bool is_embedded_picture(std::string_view address) {
  for (const char* kind : {"png", "jpeg", "jpg", "gif", "webp"}) {
    if (address.starts_with("data:image/" + std::string(kind) + ";base64,")) return true;
  }
  return false;
}

bool is_text(std::string_view attribute) {
  return attribute == "id" || attribute == "class" || attribute.starts_with("aria-") ||
         attribute.starts_with("data-");
}

std::string namespace_of(std::string_view attribute) {
  if (attribute == "xmlns" || attribute == "xmlns:svg") return "http://www.w3.org/2000/svg";
  if (attribute == "xmlns:xlink") return "http://www.w3.org/1999/xlink";
  return "";
}

class SvgReader {
 public:
  explicit SvgReader(const std::string& bytes) : bytes_(bytes) {}

  std::vector<SvgFault> faults() {
    if (auto excess = excess_of_svg(bytes_)) return {*std::move(excess)};
    if (refuse_bytes()) return std::move(faults_);
    tinyxml2::XMLDocument document;
    if (document.Parse(bytes_.data(), bytes_.size()) != tinyxml2::XML_SUCCESS) {
      refuse({0, 1}, "the drawing is not XML");
      return std::move(faults_);
    }
    walk(document);
    return std::move(faults_);
  }

 private:
  // Each kind once: a program that writes such things writes thousands of them. Nobody mends a
  // hundred kinds by hand.
  void refuse(Span span, const std::string& message, const std::string& cure = kPlain) {
    if (faults_.size() == kMostFaults) return;
    if (told_.insert(message).second) faults_.push_back({span, message, cure});
  }

  // Browsers must read the same characters as we do.
  bool refuse_bytes() {
    if (const auto bad = find_invalid_utf8(bytes_)) {
      refuse({*bad, *bad + 1}, "the drawing is not in UTF-8", "save it in UTF-8");
      return true;
    }
    const auto at = find_control_character(bytes_);
    if (!at) return false;
    refuse({*at, *at + 1}, "the drawing has a control character", "save it again, as text");
    return true;
  }

  void walk(const XMLNode& parent) {
    for (const XMLNode* node = parent.FirstChild(); node != nullptr; node = node->NextSibling()) {
      if (const auto* declaration = node->ToDeclaration()) {
        read_declaration(declaration->Value(), node->PreviousSibling() == nullptr &&
                                                   node->Parent() == node->GetDocument());
      } else if (node->ToUnknown() != nullptr) {
        refuse(find("<!"), "a drawing has no `<!DOCTYPE>` and no entities",
               "remove it: browsers need none");
      } else if (const XMLElement* element = node->ToElement()) {
        read_element(*element);
      }
    }
  }

  // "xml version="1.0" encoding="UTF-8""; all other instructions to a browser are refused.
  void read_declaration(const std::string& text, bool first) {
    const Span span = find("<?");
    std::string plain;
    for (const char c : text) {
      if (c != ' ' && c != '\n' && c != '\r' && c != '\t') plain += c == '\'' ? '"' : c;
    }
    std::transform(plain.begin(), plain.end(), plain.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    static const std::set<std::string> known{
        "xmlversion=\"1.0\"",
        "xmlversion=\"1.0\"encoding=\"utf-8\"",
        "xmlversion=\"1.0\"standalone=\"no\"",
        "xmlversion=\"1.0\"standalone=\"yes\"",
        "xmlversion=\"1.0\"encoding=\"utf-8\"standalone=\"no\"",
        "xmlversion=\"1.0\"encoding=\"utf-8\"standalone=\"yes\""};
    if (first && known.contains(plain)) return;
    refuse(span, "a drawing has no instructions for the browser",
           "remove it; the first line may be `<?xml version=\"1.0\" encoding=\"UTF-8\"?>`");
  }

  void read_element(const XMLElement& element) {
    const std::string name = element.Name();
    const Span span = find("<" + name);
    if (!is_svg_element(name)) {
      refuse(span, "a drawing cannot have the element `" + name + "`");
      pass(element);
      return;
    }
    for (const XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
      read_attribute(name, a->Name(), a->Value());
    }
    if (name == "style") read_style(element);
    walk(element);
  }

  void read_attribute(const std::string& element, const std::string& name,
                      const std::string& value) {
    const Span span = find(name);
    if (!is_svg_attribute(name)) {
      refuse(span, "a drawing cannot have the attribute `" + name + "`");
    } else if (name.starts_with("xmlns")) {
      if (value != namespace_of(name)) {
        refuse(span, "a drawing cannot have elements of another language");
      }
    } else if (name == "href" || name == "xlink:href") {
      const bool inside =
          value.starts_with('#') || (element == "image" && is_embedded_picture(value));
      if (!inside) {
        refuse(span, "a drawing cannot have an address outside of it",
               "refer to a part of it, `#name`, or embed a picture: `data:image/png;base64,…`");
      }
    } else if (!is_text(name)) {
      if (const std::string trouble = css_trouble(value); !trouble.empty()) {
        refuse(span, "a drawing cannot have " + trouble);
      }
    }
  }

  void read_style(const XMLElement& style) {
    std::string css;
    for (const XMLNode* node = style.FirstChild(); node != nullptr; node = node->NextSibling()) {
      if (node->ToText() != nullptr) css += node->Value();
    }
    if (const std::string trouble = css_trouble(css); !trouble.empty()) {
      refuse({cursor_, cursor_ + 1}, "a drawing cannot have " + trouble);
    }
  }

  // The walk goes on behind what was refused.
  void pass(const XMLElement& element) {
    for (const XMLElement* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      find(std::string("<") + child->Name());
      pass(*child);
    }
  }

  // Where `text` stands next; the walk is in the order of the file.
  Span find(const std::string& text) {
    const std::size_t at = bytes_.find(text, cursor_);
    if (at == bytes_.npos) return {cursor_, cursor_ + 1};
    cursor_ = at + text.size();
    return {at, cursor_};
  }

  const std::string& bytes_;
  std::size_t cursor_ = 0;
  std::set<std::string> told_;
  std::vector<SvgFault> faults_;
};

// HTML has a thousand names for characters that XML has not, `&lpar;` for a bracket, and reads a
// number without its semicolon.
bool has_other_references(std::string_view text) {
  for (std::size_t at = text.find('&'); at != text.npos; at = text.find('&', at + 1)) {
    const std::string_view name = text.substr(at + 1, text.find(';', at) - at - 1);
    constexpr std::array known{"amp", "lt", "gt", "quot", "#x9", "#xA", "#xD"};
    if (std::ranges::count(known, name) == 0 || at + 1 + name.size() == text.size()) return true;
  }
  return false;
}

// As site/press/script/plot/svg.ts writes 10 to a power.
constexpr std::string_view kClassOfPowers = "power";

bool has_own_names(const XMLElement& element, const std::string& name) {
  for (const XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    const std::string_view attribute = a->Name();
    const std::string_view value = a->Value();
    const bool known = attribute == "id"      ? value.starts_with(name + "-")
                       : attribute == "class" ? value == kClassOfPowers
                                              : attribute != "role" && !is_text(attribute);
    if (!known) return false;
  }
  for (const XMLElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    if (!has_own_names(*child, name)) return false;
  }
  return true;
}

}  // namespace

bool is_part_of_page(const std::string& bytes, const std::string& name) {
  tinyxml2::XMLDocument document;
  return !has_other_references(bytes) && faults_of_svg(bytes).empty() &&
         document.Parse(bytes.data(), bytes.size()) == tinyxml2::XML_SUCCESS &&
         has_own_names(*document.RootElement(), name);
}

std::vector<SvgFault> faults_of_svg(const std::string& bytes) {
  return SvgReader(bytes).faults();
}

}  // namespace mjcourse
