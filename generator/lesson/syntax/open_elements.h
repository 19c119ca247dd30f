// The elements of raw HTML that are open at a place of a lesson, as its tree is walked.
//
// An element may hold Markdown, so its two tags are in different nodes of the tree. But it must end
// in the paragraph, the item or the quote that it began in, or browsers differ in what they show. A
// browser itself ends the elements that need no end tag in HTML, such as `<li>`.
// Tested by tests/generator/lesson/blocks/read_html_test.cpp.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "lesson/syntax/html_tags.h"
#include "lesson/syntax/markdown.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

class OpenElements {
 public:
  // `tag` stands at `span`, in a child of `parent`. Of one that is refused for something else, no
  // more is told.
  void read(const HtmlTag& tag, cmark_node* parent, Span span, bool refused, Reading& reading);

  // Something was no whole tag: from there on, nobody knows what is open.
  void give_up();

  // `parent` ends, and so must what began in it.
  void end(cmark_node* parent, Reading& reading);

 private:
  struct Element {
    std::string name;
    cmark_node* parent;
    Span span;
    bool refused;
  };

  void close(const HtmlTag& tag, cmark_node* parent, Span span, Reading& reading);
  void refuse_end(const HtmlTag& tag, Span span, Reading& reading);
  void end_last(Reading& reading);

  std::vector<Element> open_;
  std::map<std::string, int> counts_;   // of those that are open, by their names
  std::multiset<std::string> refused_;  // whose ends are then not refused as well
  bool known_ = true;
};

}  // namespace mjcourse
