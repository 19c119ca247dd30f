#include "lesson/blocks/read_mere_text.h"

#include <algorithm>

#include "lesson/syntax/mere_text.h"

namespace mjcourse {
namespace {

bool holds_text(cmark_node* node) {
  const cmark_node_type type = cmark_node_get_type(node);
  if (type == CMARK_NODE_PARAGRAPH || type == CMARK_NODE_HEADING) return true;
  const std::string_view name = cmark_node_get_type_string(node);
  return name == "table_row" || name == "table_header";
}

std::size_t end_of_line(const std::string& text, std::size_t at) {
  return std::min(text.find('\n', at), text.size());
}

// The lines of `node` in its text, as they were written.
Span lines_of(cmark_node* node, const LocatedText& located, bool in_document,
              const SourceText& source) {
  const std::string& text = located.text;
  const int first = cmark_node_get_start_line(node);
  const int last = std::max(first, cmark_node_get_end_line(node));
  std::size_t begin = 0;
  if (in_document) {
    begin = source.line_start(first);
  } else {
    for (int i = 1; i < first && begin < text.size(); ++i) begin = end_of_line(text, begin) + 1;
  }
  begin = std::min(begin, text.size());
  std::size_t end = end_of_line(text, begin);
  for (int i = first; i < last && end < text.size(); ++i) end = end_of_line(text, end + 1);
  return {begin, end};
}

// A row that an empty line cut off from the table above it.
void warn_of_lone_row(cmark_node* node, Span lines, Reading& reading) {
  const SourceText& source = reading.source();
  cmark_node* above = cmark_node_previous(node);
  if (above == nullptr || std::string_view(cmark_node_get_type_string(above)) != "table") return;
  std::string_view row = source.text().substr(lines.begin, lines.end - lines.begin);
  row = row.substr(0, row.find('\n'));
  const std::size_t bar = row.find_first_not_of(" \t>");
  if (bar == row.npos || row[bar] != '|' || row.find('|', bar + 1) == row.npos) return;
  const int line = source.position(lines.begin).line;
  if (line == 1 || source.line(line - 1).find_first_not_of(" \t>") != std::string_view::npos)
    return;
  reading.warning("W-table-head", {lines.begin + bar, lines.begin + row.size()},
                  "this row is in no table: an empty line ended the one above",
                  "remove the empty line; for a bar as text, write `\\|`");
}

}  // namespace

void warn_of_mere_text(cmark_node* node, const LocatedText& text, bool in_document,
                       const Lesson& lesson, Reading& reading) {
  if (!holds_text(node) || cmark_node_get_start_line(node) < 1) return;
  const Span lines = lines_of(node, text, in_document, reading.source());
  warn_of_lone_row(node, text.span(lines.begin, lines.end), reading);
  const auto source = std::string_view(text.text).substr(lines.begin, lines.end - lines.begin);
  if (!is_suspicious(source)) return;
  std::string shown = plain_text(node);
  // A callout's title is no longer in its paragraph.
  const Block* block = lesson.block(cmark_node_parent(node));
  const auto* callout = block != nullptr ? std::get_if<Callout>(block) : nullptr;
  const bool is_first = cmark_node_previous(node) == nullptr;
  if (callout != nullptr && is_first && callout->title) {
    shown = plain_text(callout->title.get()) + " " + shown;
  }
  for (const MereText& mere : mere_text(source, shown)) {
    reading.warning(mere.id, text.span(lines.begin + mere.begin, lines.begin + mere.end),
                    mere.message, mere.cure);
  }
}

}  // namespace mjcourse
