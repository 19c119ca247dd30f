#include "lesson/blocks/read_footnote.h"

#include <cmark-gfm/node.h>

#include <string_view>

#include "lesson/blocks/read_losses.h"

namespace mjcourse {
namespace {

std::string name_of_footnote(cmark_node* node) {
  const cmark_chunk& label = node->as.literal;
  return {reinterpret_cast<const char*>(label.data), static_cast<std::size_t>(label.len)};
}

}  // namespace

SourceCursor begin_of_footnote(cmark_node* node, const LocatedText& text, bool in_document,
                               const SourceText& source) {
  const int line = cmark_node_get_start_line(node);
  if (in_document) return {text, source.line_start(line)};
  SourceCursor begin{text};
  for (int i = 1; i < line; ++i) begin.at = text.text.find('\n', begin.at) + 1;
  return begin;
}

void refuse_second_footnote(cmark_node* node, FootnoteNames& names, Reading& reading) {
  const std::string name = name_of_footnote(node);
  if (names.insert(name).second) return;
  const int line = cmark_node_get_start_line(node);
  const std::size_t at = reading.source().line_start(line);
  const std::size_t end = reading.source().line(line).find(']');
  refuse_second_footnote(name, {at, at + (end == std::string_view::npos ? 1 : end + 1)}, reading);
}

void refuse_footnote_in_link(cmark_node* node, SourceCursor cursor, Reading& reading) {
  const bool in_heading = stands_in(node, CMARK_NODE_HEADING);
  if (!in_heading && !stands_in(node, CMARK_NODE_LINK)) return;
  cmark_node* named = node->parent_footnote_def != nullptr ? node->parent_footnote_def : node;
  reading.error("E-footnote-place", cursor.find("[^" + name_of_footnote(named) + "]").span(),
                in_heading ? "a footnote's mark cannot stand in a heading, which is a link itself"
                           : "a footnote's mark cannot stand in the text of a link",
                in_heading ? "put it into the text below" : "put it after the link");
}

}  // namespace mjcourse
