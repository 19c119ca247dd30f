#include "page/inline_styles.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace mjcourse {
namespace {

struct Attribute {
  std::string_view name, value, text;  // `text` is all of it, quotes included
};

// A tag that opens an element, attribute by attribute.
struct Tag {
  std::string_view name;
  std::vector<Attribute> attributes;
  std::string_view close;  // ">" or "/>"

  std::string_view value_of(std::string_view attribute) const {
    for (const Attribute& known : attributes) {
      if (known.name == attribute) return known.value;
    }
    return {};
  }
};

// Takes from `rest` all up to the first of `ends`.
std::string_view take_until(std::string_view& rest, std::string_view ends) {
  const std::string_view taken = rest.substr(0, rest.find_first_of(ends));
  rest.remove_prefix(taken.size());
  return taken;
}

Attribute take_attribute(std::string_view& rest) {
  const std::string_view from = rest;
  Attribute attribute;
  attribute.name = take_until(rest, " \t\r\n=/>");
  if (rest.starts_with('=')) {
    rest.remove_prefix(1);
    const bool quoted = rest.starts_with('"') || rest.starts_with('\'');
    const std::string_view quote = quoted ? rest.substr(0, 1) : " \t\r\n>";
    if (quoted) rest.remove_prefix(1);
    attribute.value = take_until(rest, quote);
    if (quoted && !rest.empty()) rest.remove_prefix(1);
  }
  attribute.text = from.substr(0, from.size() - rest.size());
  return attribute;
}

// Takes a tag from `rest`, which starts with its "<".
Tag take_tag(std::string_view& rest) {
  rest.remove_prefix(1);
  Tag tag;
  tag.name = take_until(rest, " \t\r\n/>");
  for (;;) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
    if (rest.empty() || rest.starts_with('>') || rest.starts_with("/>")) break;
    if (rest.starts_with('/') || rest.starts_with('=')) {
      rest.remove_prefix(1);  // astray: browsers skip it too
    } else {
      tag.attributes.push_back(take_attribute(rest));
    }
  }
  tag.close = rest.substr(0, rest.find('>') + 1);
  rest.remove_prefix(tag.close.size());
  return tag;
}

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
  std::string taken;
  std::string_view rest = html;
  while (!rest.empty()) {
    const std::string_view text = rest.substr(0, rest.find('<'));
    taken += text;
    rest.remove_prefix(text.size());
    const bool opens = rest.size() > 1 && std::isalpha(static_cast<unsigned char>(rest[1])) != 0;
    if (!opens) {
      taken += rest.substr(0, 1);
      rest.remove_prefix(std::min<std::size_t>(1, rest.size()));
      continue;
    }
    const std::string_view from = rest;
    const Tag tag = take_tag(rest);
    const std::string_view style = tag.value_of("style");
    if (style.empty()) {
      taken += from.substr(0, from.size() - rest.size());
      continue;
    }
    const std::string_view given = tag.value_of("class");
    taken += "<" + std::string(tag.name) + " class=\"" + std::string(given) +
             (given.empty() ? "" : " ") + class_of(without_references(style)) + "\"";
    for (const Attribute& attribute : tag.attributes) {
      if (attribute.name == "style" || attribute.name == "class") continue;
      taken += " " + std::string(attribute.text);
    }
    taken += tag.close;
  }
  return taken;
}

}  // namespace mjcourse
