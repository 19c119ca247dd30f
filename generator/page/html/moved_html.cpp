#include "page/html/moved_html.h"

#include <algorithm>
#include <array>

#include "page/html/html_tag.h"

namespace mjcourse {
namespace {

template <std::size_t Count>
bool is_one_of(std::string_view name, const std::array<std::string_view, Count>& names) {
  return std::ranges::find(names, name) != names.end();
}

constexpr std::array<std::string_view, 5> kNamesIds{"id", "for", "aria-labelledby",
                                                    "aria-describedby", "popovertarget"};
constexpr std::array<std::string_view, 4> kAddresses{"href", "src", "srcset", "poster"};
constexpr std::array<std::string_view, 13> kLively{
    "loading",      "data-module",    "data-code",   "data-engine", "data-wasm",
    "data-program", "data-style",     "data-worker", "data-llvm",   "data-pack",
    "data-bytes",   "data-arguments", "data-exit"};

// A list of ids, with spaces between them.
std::string prefixed(std::string_view ids, const std::string& prefix) {
  std::string all = ids.empty() ? "" : prefix;
  for (const char c : ids) {
    all += c;
    if (c == ' ') all += prefix;
  }
  return all;
}

// The parts of a drawing name each other by `url(#id)`.
std::string with_prefixed_urls(std::string value, const std::string& prefix) {
  const std::string_view begin = "url(#";
  for (std::size_t at = 0; (at = value.find(begin, at)) != value.npos;) {
    at += begin.size();
    value.insert(at, prefix);
  }
  return value;
}

std::string moved_attribute(const HtmlAttribute& attribute, const HtmlMove& move) {
  const auto with = [&](const std::string& value) {
    return " " + std::string(attribute.name) + "=\"" + value + "\"";
  };
  if (is_one_of(attribute.name, kNamesIds)) return with(prefixed(attribute.value, move.prefix));
  if (move.address && is_one_of(attribute.name, kAddresses)) {
    return with(move.address(attribute.value));
  }
  if (attribute.value.find("url(#") != std::string_view::npos) {
    return with(with_prefixed_urls(std::string(attribute.value), move.prefix));
  }
  return " " + std::string(attribute.text);
}

bool is_heading(std::string_view name) {
  return name.size() == 2 && name[0] == 'h' && name[1] >= '1' && name[1] <= '5';
}

// Also that of the tag that closes it.
std::string deeper_headings(std::string html) {
  for (std::size_t at = 0; (at = html.find('<', at)) != html.npos; ++at) {
    std::size_t name = at + 1;
    if (html[name] == '/') ++name;
    const bool ends = name + 2 < html.size() && (html[name + 2] == ' ' || html[name + 2] == '>');
    if (ends && is_heading(std::string_view(html).substr(name, 2))) ++html[name + 1];
  }
  return html;
}

}  // namespace

std::string moved_html(const std::string& html, const HtmlMove& move) {
  std::string moved = with_tags(html, [&](const HtmlTag& tag) {
    std::string text = "<" + std::string(tag.name);
    for (const HtmlAttribute& attribute : tag.attributes) {
      if (move.still && is_one_of(attribute.name, kLively)) continue;
      text += moved_attribute(attribute, move);
    }
    return text + std::string(tag.close);
  });
  return move.deeper ? deeper_headings(std::move(moved)) : moved;
}

}  // namespace mjcourse
