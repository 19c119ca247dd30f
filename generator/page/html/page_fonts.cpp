#include "page/html/page_fonts.h"

#include <algorithm>
#include <string>

#include "base/utf8.h"

namespace mjcourse {
namespace {

// Where the element that `html` begins with ends; there may be others in it.
std::size_t details_end(std::string_view html) {
  constexpr std::string_view begins = "<details", ends = "</details>";
  std::size_t depth = 0, at = 0;
  do {
    const std::size_t end = html.find(ends, at);
    if (end == html.npos) return html.size();
    const std::size_t inner = html.find(begins, at);
    depth = inner < end ? depth + 1 : depth - 1;
    at = inner < end ? inner + begins.size() : end + ends.size();
  } while (depth > 0);
  return at;
}

bool is_open(std::string_view details) {
  return details.substr(0, details.find('>')).ends_with(" open");
}

// `body` without what a reader sees only on demand, or on paper: its fonts are not asked for ahead.
std::string shown_at_once(std::string_view body) {
  body = body.substr(0, body.find("<section class=\"answers\""));
  std::string shown;
  while (true) {
    const std::size_t begin = std::min(body.find("<details"), body.size());
    shown += body.substr(0, begin);
    body.remove_prefix(begin);
    if (body.empty()) return shown;
    body.remove_prefix(is_open(body) ? std::min(body.find('>'), body.size()) : details_end(body));
  }
}

bool begins_with_letter(std::string_view text) {
  return !text.empty() && is_letter(text.front());
}

// U+0370 to U+03FF, in UTF-8.
bool is_greek(std::string_view text) {
  return text.starts_with('\xcd') || text.starts_with('\xce') || text.starts_with('\xcf');
}

// What the first pieces of KaTeX's large fonts have (site/bundle/font-cuts.mjs).
bool is_large(std::string_view text) {
  constexpr std::string_view signs[] = {"(", ")", "[", "]", "∑", "∫"};
  return std::ranges::any_of(signs, [&](std::string_view sign) { return text.starts_with(sign); });
}

// A font, and the classes of the elements that KaTeX sets in it, if they begin so.
struct FormulaFont {
  std::string_view name;
  std::string_view of;
  bool (*begins)(std::string_view text);
};

constexpr FormulaFont kFormulaFonts[] = {
    {"letters.woff2", "mord mathnormal", begins_with_letter},
    {"greek.woff2", "mord mathnormal", is_greek},
    {"upright-bold.woff2", "mord mathbf", begins_with_letter},
    {"bold-letters.woff2", "mord boldsymbol", begins_with_letter},
    {"bold-greek.woff2", "mord boldsymbol", is_greek},
    {"large.woff2", "op-symbol small-op", is_large},
    {"large.woff2", "delimsizing size1", is_large},
    {"larger.woff2", "op-symbol large-op", is_large},
    {"larger.woff2", "delimsizing size2", is_large},
};

bool is_set_in(std::string_view body, const FormulaFont& font) {
  for (std::size_t at = body.find(font.of); at != body.npos; at = body.find(font.of, at + 1)) {
    const std::size_t end = body.find('>', at);
    if (end == body.npos) return false;
    if (font.begins(body.substr(end + 1))) return true;
  }
  return false;
}

// A lab's note is set without serifs.
bool slants_in_a_note(std::string_view body) {
  constexpr std::string_view note = "class=\"lab-note\"";
  for (std::size_t at = body.find(note); at != body.npos; at = body.find(note, at + 1)) {
    if (body.find("<em>", at) < body.find("</div>", at)) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string_view> page_fonts(std::string_view body) {
  const std::string shown = shown_at_once(body);
  const auto has = [&](std::string_view text) { return shown.find(text) != shown.npos; };
  std::vector<std::string_view> fonts = {"serif.woff2", "sans.woff2"};
  const bool heads = has("class=\"lesson-head\"") || has("class=\"reference-head\"");
  if ((heads && has("<p class=\"summary\"")) || has("<em>")) fonts.push_back("italic.woff2");
  if (slants_in_a_note(shown)) fonts.push_back("sans-italic.woff2");
  if (has("<code")) fonts.push_back("mono.woff2");
  if (!has("class=\"katex\"")) return fonts;
  fonts.push_back("formula.woff2");
  for (const FormulaFont& font : kFormulaFonts) {
    if (fonts.back() != font.name && is_set_in(shown, font)) fonts.push_back(font.name);
  }
  return fonts;
}

}  // namespace mjcourse
