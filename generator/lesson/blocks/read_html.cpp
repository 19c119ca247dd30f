#include "lesson/blocks/read_html.h"

#include <algorithm>

#include "lesson/syntax/hidden_markdown.h"
#include "lesson/syntax/raw_html.h"

namespace mjcourse {
namespace {

void read_tags(cmark_node* node, const LocatedText& html, const std::vector<HtmlFault>& faults,
               OpenElements& open, Reading& reading) {
  for (const HtmlTag& tag : tags_of_html(html.text)) {
    const bool refused = std::any_of(faults.begin(), faults.end(), [&](const HtmlFault& fault) {
      return fault.begin >= tag.begin && fault.begin < tag.end;
    });
    open.read(tag, cmark_node_parent(node), html.span(tag.begin, tag.end), refused, reading);
  }
}

void refuse_hidden_markdown(const LocatedText& html, Reading& reading) {
  for (const HiddenMarkdown& hidden : hidden_markdown(html.text)) {
    reading.error("E-html-hidden", html.span(hidden.begin, hidden.end),
                  std::string(hidden.what) +
                      " right beside a tag is not Markdown, and is shown as it is written",
                  "leave an empty line between the tag and it");
  }
}

}  // namespace

void read_html(cmark_node* node, const LocatedText& html, HtmlState& state, Reading& reading) {
  const std::vector<HtmlFault> faults = faults_of_html(html.text, state.refused);
  for (const HtmlFault& fault : faults) {
    reading.error(fault.id, html.span(fault.begin, fault.end), fault.message, fault.cure);
  }
  const auto is_broken = [](const HtmlFault& fault) { return fault.id == "E-html-broken"; };
  if (std::any_of(faults.begin(), faults.end(), is_broken)) return state.open.give_up();
  read_tags(node, html, faults, state.open, reading);
  if (cmark_node_get_type(node) == CMARK_NODE_HTML_BLOCK) refuse_hidden_markdown(html, reading);
}

}  // namespace mjcourse
