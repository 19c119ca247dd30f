// Raw HTML of a lesson, a block of lines or a tag in a line (raw_html.h).
#include <algorithm>

#include "lesson/blocks/lesson_reader.h"
#include "lesson/syntax/hidden_markdown.h"
#include "lesson/syntax/raw_html.h"

namespace mjcourse {

void LessonReader::read_html(cmark_node* node, Region& region) {
  const LocatedText html = find(cmark_node_get_literal(node), region);
  const std::vector<HtmlFault> faults = faults_of_html(html.text, refused_html_);
  for (const HtmlFault& fault : faults) {
    reading_.error(fault.id, html.span(fault.begin, fault.end), fault.message, fault.cure);
  }
  const auto is_broken = [](const HtmlFault& fault) { return fault.id == "E-html-broken"; };
  if (std::any_of(faults.begin(), faults.end(), is_broken)) return open_elements_.give_up();
  read_tags(node, html, faults);
  if (cmark_node_get_type(node) == CMARK_NODE_HTML_BLOCK) refuse_hidden_markdown(html);
}

void LessonReader::read_tags(cmark_node* node, const LocatedText& html,
                             const std::vector<HtmlFault>& faults) {
  for (const HtmlTag& tag : tags_of_html(html.text)) {
    const bool refused = std::any_of(faults.begin(), faults.end(), [&](const HtmlFault& fault) {
      return fault.begin >= tag.begin && fault.begin < tag.end;
    });
    open_elements_.read(tag, cmark_node_parent(node), html.span(tag.begin, tag.end), refused,
                        reading_);
  }
}

void LessonReader::refuse_hidden_markdown(const LocatedText& html) {
  for (const HiddenMarkdown& hidden : hidden_markdown(html.text)) {
    reading_.error(
        "E-html-hidden", html.span(hidden.begin, hidden.end),
        std::string(hidden.what) + " right beside a tag is no Markdown, and shown as it is written",
        "leave an empty line between the tag and it");
  }
}

}  // namespace mjcourse
