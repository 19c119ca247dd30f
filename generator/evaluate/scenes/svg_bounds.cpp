#include "evaluate/scenes/svg_bounds.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace mjcourse {
namespace {

constexpr std::size_t kMostBytes = 16 << 20;
constexpr std::size_t kMostAttributes = 200;  // of an element; what draws has eighty in all

// What a piece of XML that is no element begins and ends with.
constexpr std::pair<std::string_view, std::string_view> kOthers[] = {
    {"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}, {"</", ">"}};

std::size_t behind(const std::string& bytes, std::string_view end, std::size_t from) {
  const std::size_t at = bytes.find(end, from);
  return at == bytes.npos ? bytes.size() : at + end.size();
}

// Where the element ends that begins at `from`, and how many attributes it has: each is a name, `=`
// and a value in quotes.
std::pair<std::size_t, std::size_t> element_at(const std::string& bytes, std::size_t from) {
  std::size_t attributes = 0;
  for (std::size_t at = from; at < bytes.size();) {
    const char c = bytes[at];
    if (c == '>') return {at + 1, attributes};
    if (c == '=') ++attributes;
    at = c == '"' || c == '\'' ? behind(bytes, std::string_view(&c, 1), at + 1) : at + 1;
  }
  return {bytes.size(), attributes};
}

}  // namespace

std::optional<SvgFault> excess_of_svg(const std::string& bytes) {
  if (bytes.size() > kMostBytes) {
    return SvgFault{{0, 1},
                    "a drawing has at most " + std::to_string(kMostBytes >> 20) + " MiB",
                    "simplify it, or save it as PNG or WebP"};
  }
  for (std::size_t at = bytes.find('<'); at != bytes.npos; at = bytes.find('<', at)) {
    const auto* const other = std::ranges::find_if(kOthers, [&](const auto& one) {
      return bytes.compare(at, one.first.size(), one.first) == 0;
    });
    if (other != std::end(kOthers)) {
      at = behind(bytes, other->second, at + other->first.size());
      continue;
    }
    const auto [end, attributes] = element_at(bytes, at + 1);
    if (attributes > kMostAttributes) {
      return SvgFault{
          {at, at + 1},
          "an element of a drawing has at most " + std::to_string(kMostAttributes) + " attributes",
          "save it again with a program that draws"};
    }
    at = end;
  }
  return std::nullopt;
}

}  // namespace mjcourse
