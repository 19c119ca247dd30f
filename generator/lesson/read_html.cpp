// Raw HTML of a lesson, a block of lines or a tag in a line (raw_html.h).
#include "lesson/lesson_reader.h"
#include "lesson/raw_html.h"

namespace mjcourse {

void LessonReader::read_html(cmark_node* node, Region& region) {
  const LocatedText html = find(cmark_node_get_literal(node), region);
  for (const HtmlFault& fault : faults_of_html(html.text, refused_html_)) {
    reading_.error(fault.id, html.span(fault.begin, fault.end), fault.message, fault.cure);
  }
}

}  // namespace mjcourse
