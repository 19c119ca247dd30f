// A page in preview, which says of which lines of its lesson each part of its text is made
// (page/html/place_marks.h); and of two such pages, what differs.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mjcourse {

struct PageMark {
  int first = 0, last = 0;  // lines of the lesson's file, from 1
  bool running = false;     // it shows a stand-in
  bool operator==(const PageMark&) const = default;
};

// Of each part in its order; none where a page has no such text.
std::vector<PageMark> marks_of(const std::string& html);

// In the place of `count` parts from `first` on, which is counted from 0, comes `html`.
struct PageChange {
  std::size_t first = 0, count = 0;
  std::string html;
};

// Nothing where they differ in more than the parts of the text. Where the same text has moved to
// other lines, no part differs.
std::optional<PageChange> page_change(const std::string& before, const std::string& after);

}  // namespace mjcourse
