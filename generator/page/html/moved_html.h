// HTML that was written for a place of its own, put somewhere else: onto a page that has other ids,
// lies in another folder, or has it twice.
//
// What is printed is made of such pieces: the answers behind a lesson, and the whole course as one
// page.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace mjcourse {

struct HtmlMove {
  std::string prefix;  // goes before each id, and before what names one in the same piece
  // What an address becomes; none: each stays as it is.
  std::function<std::string(std::string_view)> address = {};
  bool deeper = false;  // a heading becomes one of the next lower level
  bool still = false;   // pictures are loaded at once, and labs and programs are only read
};

std::string moved_html(const std::string& html, const HtmlMove& move);

}  // namespace mjcourse
