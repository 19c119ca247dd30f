#include "lesson/blocks/read_link.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace mjcourse {
namespace {

void refuse_link_in_heading(const Link& link, Reading& reading) {
  if (!stands_in(link.node, CMARK_NODE_HEADING)) return;
  reading.error("E-link-place", link.target.span(),
                "a link cannot stand in a heading, which is a link itself",
                "put it into the text below");
}

// Nobody sees it.
void refuse_empty_link(const Link& link, Reading& reading) {
  const std::string words = plain_text(link.node);
  if (words.find_first_not_of(" \t") != words.npos) return;
  cmark_node* child = cmark_node_first_child(link.node);
  while (child != nullptr && cmark_node_get_type(child) != CMARK_NODE_IMAGE) {
    child = cmark_node_next(child);
  }
  if (child != nullptr) return;
  reading.error("E-link-text", link.target.span(), "this link has no words, so nobody sees it",
                "write them between its brackets: `[words](…)`");
}

// `<https://…>`, whose words begin at the cursor.
ReadLink read_autolink(cmark_node* node, SourceCursor words, Reading& reading) {
  LocatedText target = words.find(plain_text(node));
  target.text = cmark_node_get_url(node);  // may begin with a `mailto:` that is not written
  target.offsets.append_still(target.text.size() + 1 - target.offsets.size(),
                              target.offsets.back());
  ReadLink read{{node, std::move(target), true}, words.at};
  refuse_link_in_heading(read.link, reading);
  return read;
}

}  // namespace

ReadLink read_link(cmark_node* node, SourceCursor cursor, Reading& reading) {
  const std::string target = cmark_node_get_url(node);
  const std::string& text = cursor.text.text;
  const std::size_t end = std::min(text.find("\n\n", cursor.at), text.size());
  const std::string_view here = std::string_view(text).substr(0, end);
  const std::string shown = plain_text(node), words = "[" + shown + "]";
  if (target == shown || target == "mailto:" + shown) {
    const std::size_t opened = here.find("<" + shown + ">", cursor.at);
    const std::size_t bracket = here.find(words, cursor.at);
    if (opened < bracket) return read_autolink(node, {cursor.text, opened + 1}, reading);
  }
  std::size_t at = here.find(words + "(" + target, cursor.at);
  if (at != here.npos) {
    at += words.size() - 1;
  } else if (here.find(words, cursor.at) == here.npos) {
    at = here.find("](" + target, cursor.at);  // there is markup in its text
  }
  const bool is_behind = at != here.npos;
  if (!is_behind) at = text.find("]: " + target);
  SourceCursor ahead{cursor.text, at == text.npos ? cursor.at : text.find(target, at)};
  ReadLink read{{node, ahead.find(target)}, is_behind ? at + 2 + target.size() : cursor.at};
  refuse_empty_link(read.link, reading);
  refuse_link_in_heading(read.link, reading);
  return read;
}

}  // namespace mjcourse
