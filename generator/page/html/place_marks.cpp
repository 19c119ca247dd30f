#include "page/html/place_marks.h"

#include <string>
#include <utility>

namespace mjcourse {
namespace {

bool is_open(cmark_node* node, const Lesson& lesson, const LessonResults& results) {
  const auto block = lesson.block_of.find(node);
  if (block != lesson.block_of.end() && results.open.contains(block->second)) return true;
  for (cmark_node* child = cmark_node_first_child(node); child != nullptr;
       child = cmark_node_next(child)) {
    if (is_open(child, lesson, results)) return true;
  }
  return false;
}

}  // namespace

PlaceMarks::PlaceMarks(const Lesson& lesson, const LessonResults& results) {
  cmark_node* node = lesson.document ? cmark_node_first_child(lesson.document.get()) : nullptr;
  for (; node != nullptr; node = cmark_node_next(node)) {
    const std::string lines = std::to_string(cmark_node_get_start_line(node)) + "-" +
                              std::to_string(cmark_node_get_end_line(node));
    const std::string state = is_open(node, lesson, results) ? " running" : "";
    Document mark(cmark_node_new(CMARK_NODE_HTML_BLOCK));
    cmark_node_set_literal(mark.get(), ("<!--lines " + lines + state + "-->").c_str());
    if (cmark_node_insert_before(node, mark.get()) != 0) marks_.push_back(std::move(mark));
    // All footnotes become one part of the page.
    if (cmark_node_get_type(node) == CMARK_NODE_FOOTNOTE_DEFINITION) return;
  }
}

PlaceMarks::~PlaceMarks() {
  for (const Document& mark : marks_) cmark_node_unlink(mark.get());
}

}  // namespace mjcourse
