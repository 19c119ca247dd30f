#include "page/html/inline_styles.h"

#include <string_view>

#include "page/html/html_tag.h"

namespace mjcourse {
namespace {

// CSS has no character references; of those that a style can need, HTML must have these.
std::string without_references(std::string_view value) {
  std::string text(value);
  for (const auto& [reference, meant] :
       {std::pair("&quot;", "\""), {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}}) {
    for (std::size_t at = 0; (at = text.find(reference, at)) != text.npos; ++at) {
      text.replace(at, std::string_view(reference).size(), meant);
    }
  }
  return text;
}

}  // namespace

const std::string& InlineStyles::class_of(const std::string& style) {
  const auto [found, is_new] = classes_.try_emplace(style, "s" + std::to_string(classes_.size()));
  if (is_new) sheet_ += "." + found->second + "{" + style + "}\n";
  return found->second;
}

std::string InlineStyles::take(const std::string& html) {
  if (html.find("style=") == html.npos) return html;
  return with_tags(html, [this](const HtmlTag& tag) {
    const std::string_view style = tag.value_of("style");
    if (style.empty()) return std::string(tag.text);
    const std::string_view given = tag.value_of("class");
    std::string taken = "<" + std::string(tag.name) + " class=\"" + std::string(given) +
                        (given.empty() ? "" : " ") + class_of(without_references(style)) + "\"";
    for (const HtmlAttribute& attribute : tag.attributes) {
      if (attribute.name == "style" || attribute.name == "class") continue;
      taken += " " + std::string(attribute.text);
    }
    return taken + std::string(tag.close);
  });
}

}  // namespace mjcourse
