// HtmlTag: one tag that opens an element, attribute by attribute.
//
// Enter with with_tags(), to change attributes of HTML that is finished: it is read as browsers
// read it, and what is not changed stays to the byte.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

struct HtmlAttribute {
  std::string_view name, value, text;  // `text` is all of it, quotes included
};

struct HtmlTag {
  std::string_view name;
  std::vector<HtmlAttribute> attributes;
  std::string_view close;  // ">" or "/>"
  std::string_view text;   // all of it

  // "" where it has none.
  std::string_view value_of(std::string_view attribute) const;
};

// `html`, in which `change` gives what stands in the place of each opening tag.
std::string with_tags(const std::string& html,
                      const std::function<std::string(const HtmlTag&)>& change);

}  // namespace mjcourse
