#include "page/html/html_tag.h"

#include <algorithm>

#include "base/utf8.h"

namespace mjcourse {
namespace {

// Takes from `rest` all up to the first of `ends`.
std::string_view take_until(std::string_view& rest, std::string_view ends) {
  const std::string_view taken = rest.substr(0, rest.find_first_of(ends));
  rest.remove_prefix(taken.size());
  return taken;
}

HtmlAttribute take_attribute(std::string_view& rest) {
  const std::string_view from = rest;
  HtmlAttribute attribute;
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
HtmlTag take_tag(std::string_view& rest) {
  const std::string_view from = rest;
  rest.remove_prefix(1);
  HtmlTag tag;
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
  tag.text = from.substr(0, from.size() - rest.size());
  return tag;
}

}  // namespace

std::string_view HtmlTag::value_of(std::string_view attribute) const {
  for (const HtmlAttribute& known : attributes) {
    if (known.name == attribute) return known.value;
  }
  return {};
}

std::string with_tags(const std::string& html,
                      const std::function<std::string(const HtmlTag&)>& change) {
  std::string changed;
  std::string_view rest = html;
  while (!rest.empty()) {
    const std::string_view text = rest.substr(0, rest.find('<'));
    changed += text;
    rest.remove_prefix(text.size());
    const bool opens = rest.size() > 1 && is_letter(rest[1]);
    if (opens) {
      changed += change(take_tag(rest));
    } else {
      changed += rest.substr(0, 1);
      rest.remove_prefix(std::min<std::size_t>(1, rest.size()));
    }
  }
  return changed;
}

}  // namespace mjcourse
