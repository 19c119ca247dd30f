#include "evaluate/scenes/svg_faults.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "base/utf8.h"
#include "base/xml_reader.h"
#include "evaluate/scenes/svg_bounds.h"
#include "evaluate/scenes/svg_names.h"

namespace mjcourse {
namespace {

constexpr const char* kPlain =
    "use only elements that draw; most programs can save a \"plain\" SVG, which has nothing else";

constexpr const char* kSaveAgain = "save it again with a program that draws";

constexpr const char* kOtherLanguage = "a drawing cannot have elements of another language";

constexpr std::size_t kMostFaults = 100;
constexpr std::size_t kMostDepth = 200;

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

constexpr std::string_view kSvg = "http://www.w3.org/2000/svg";
constexpr std::string_view kXlink = "http://www.w3.org/1999/xlink";
constexpr std::string_view kXml = "http://www.w3.org/XML/1998/namespace";

// The name of an attribute where its namespaces have their usual prefixes; "" of others.
std::string usual_name(const XmlName& name) {
  if (name.space.empty()) return std::string(name.local);
  if (name.space == kXlink) return "xlink:" + std::string(name.local);
  if (name.space == kXml) return "xml:" + std::string(name.local);
  return "";
}

class SvgReader : public XmlReader {
 public:
  explicit SvgReader(const std::string& bytes) : XmlReader(bytes), bytes_(bytes) {}

  std::vector<SvgFault> faults() {
    if (auto excess = excess_of_svg(bytes_)) return {*std::move(excess)};
    if (refuse_bytes()) return std::move(faults_);
    if (const auto mistake = read()) {
      refuse(mistake->span, "the drawing is not XML: " + mistake->message,
             mistake->cure.empty() ? kSaveAgain : mistake->cure);
    }
    return std::move(faults_);
  }

 private:
  // Each kind once: a program that writes such things writes thousands of them. Nobody mends a
  // hundred kinds by hand.
  void refuse(Span span, const std::string& message, const std::string& cure = kPlain) {
    if (faults_.size() == kMostFaults) return stop();
    if (told_.insert(message).second) faults_.push_back({span, message, cure});
  }

  // Its place is looked for only where it is told.
  void refuse_attribute(const std::string& name, const std::string& message,
                        const std::string& cure = kPlain) {
    if (!told_.contains(message)) refuse(place_of_attribute(name), message, cure);
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

  void declare(const XmlDeclaration& declaration) override {
    if (declaration.is_plain()) return;
    refuse(head("<?"), "a drawing is XML 1.0 in UTF-8, and says nothing else",
           R"(save it in UTF-8; its first line may be `<?xml version="1.0" encoding="UTF-8"?>`)");
  }

  void instruct() override {
    refuse(head("<?"), "a drawing has no instructions for the browser", "remove it");
  }

  void type(bool defines) override {
    const std::string open = "<!DOCTYPE";
    const std::size_t at = bytes_.rfind(open, here().begin);
    refuse({at, at + open.size()}, "a drawing has no `<!DOCTYPE>` and no entities",
           "remove it: browsers need none");
    if (defines) stop();
  }

  void begin(const XmlElement& element) override {
    if (++depth_ > kMostDepth) {
      refuse(
          head("<"),
          "elements of a drawing are at most " + std::to_string(kMostDepth) + " deep in each other",
          "take groups apart that hold nothing but a group");
      return stop();
    }
    if (is_passed()) return;
    if (depth_ == 1 && !read_root(element)) return stop();
    if (!read_element(element)) passed_ = depth_;
  }

  void end() override {
    if (depth_ == style_) {
      if (const std::string trouble = css_trouble(css_); !trouble.empty()) {
        refuse(style_span_, "a drawing cannot have " + trouble);
      }
      style_ = 0;
    }
    if (depth_ == passed_) passed_ = 0;
    --depth_;
  }

  void text(std::string_view text) override {
    if (style_ > 0) css_ += text;
  }

  // A browser shows a file as a drawing for its namespace alone. False where it is something else.
  bool read_root(const XmlElement& element) {
    const XmlName& name = element.name;
    if (name.local == "svg" && name.space == kSvg) return true;
    const Span span = head("<" + name.text());
    if (name.text() == "svg" && element.namespaces.empty()) {
      own_ = "";
      refuse(span, "the drawing does not say that it is SVG",
             "write `<svg xmlns=\"" + std::string(kSvg) + "\"`, or browsers show nothing of it");
      return true;
    }
    refuse(span, "the first element of a drawing is `svg`", "save it again as SVG");
    return false;
  }

  // False where what the element holds is not looked at.
  bool read_element(const XmlElement& element) {
    const std::string name = element.name.text();
    const Span span = head("<" + name);
    const bool is_own = element.name.space == own_;
    const bool can_be = is_own && is_svg_element(element.name.local);
    if (!can_be && (is_own || !element.name.prefix.empty())) {
      refuse(span, "a drawing cannot have the element `" + name + "`");
      return false;
    }
    for (const XmlNamespace& one : element.namespaces) read_namespace(one);
    if (!is_own) {
      refuse(span, kOtherLanguage);
      return false;
    }
    for (const XmlAttribute& attribute : element.attributes) {
      read_attribute(element.name.local, attribute);
    }
    if (element.name.local == "style" && style_ == 0) {
      style_ = depth_;
      style_span_ = span;
      css_.clear();
    }
    return true;
  }

  // Those of a prefix that drawings need are told of where they name another language.
  void read_namespace(const XmlNamespace& one) {
    if (one.space == kSvg || (one.space == kXlink && !one.prefix.empty())) return;
    const std::string name = one.prefix.empty() ? "xmlns" : "xmlns:" + one.prefix;
    const bool is_usual = one.prefix.empty() || one.prefix == "svg" || one.prefix == "xlink";
    refuse_attribute(
        name, is_usual ? kOtherLanguage : "a drawing cannot have the attribute `" + name + "`");
  }

  void read_attribute(std::string_view element, const XmlAttribute& attribute) {
    const std::string name = usual_name(attribute.name);
    const std::string_view value = attribute.value;
    const auto refuse_it = [&](const std::string& message, const std::string& cure = kPlain) {
      refuse_attribute(attribute.name.text(), message, cure);
    };
    if (!is_svg_attribute(name)) {
      refuse_it("a drawing cannot have the attribute `" + attribute.name.text() + "`");
    } else if (name == "href" || name == "xlink:href") {
      const bool inside =
          value.starts_with('#') || (element == "image" && is_embedded_picture(value));
      if (!inside) {
        refuse_it("a drawing cannot have an address outside of it",
                  "refer to a part of it, `#name`, or embed a picture: `data:image/png;base64,…`");
      }
    } else if (!is_text(name)) {
      if (const std::string trouble = css_trouble(value); !trouble.empty()) {
        refuse_it("a drawing cannot have " + trouble);
      }
    }
  }

  bool is_passed() const { return passed_ > 0; }

  // The beginning of what is being read.
  Span head(const std::string& text) const {
    const std::size_t at = here().begin;
    return {at, at + text.size()};
  }

  const std::string& bytes_;
  std::string_view own_ = kSvg;  // the namespace of what draws
  std::size_t depth_ = 0;
  std::size_t passed_ = 0;  // the depth of what is not looked at; 0 where all is
  std::size_t style_ = 0;   // of the style whose text is being read
  Span style_span_;
  std::string css_;
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

// Looks for names that are not the drawing's own, and for what HTML reads otherwise.
class NameReader : public XmlReader {
 public:
  NameReader(const std::string& bytes, const std::string& name) : XmlReader(bytes), name_(name) {}

  bool finds_own_alone() { return !read() && are_own_; }

 private:
  void begin(const XmlElement& element) override {
    if (!element.name.prefix.empty()) are_own_ = false;
    for (const XmlAttribute& attribute : element.attributes) {
      if (!is_own(attribute.name.text(), attribute.value)) are_own_ = false;
    }
    if (!are_own_) stop();
  }

  bool is_own(const std::string& attribute, std::string_view value) const {
    if (attribute == "id") return value.starts_with(name_ + "-");
    if (attribute == "class") return value == kClassOfPowers;
    return attribute != "role" && !is_text(attribute);
  }

  const std::string& name_;
  bool are_own_ = true;
};

}  // namespace

bool is_part_of_page(const std::string& bytes, const std::string& name) {
  return !has_other_references(bytes) && faults_of_svg(bytes).empty() &&
         NameReader(bytes, name).finds_own_alone();
}

std::vector<SvgFault> faults_of_svg(const std::string& bytes) {
  return SvgReader(bytes).faults();
}

}  // namespace mjcourse
