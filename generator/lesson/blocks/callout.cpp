#include "lesson/blocks/callout.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>

#include "base/nearest.h"

namespace mjcourse {
namespace {

// cmark lets the text of inlines lie in their paragraph, and copies it when it is asked for. What
// leaves a paragraph that may be freed needs a copy.
void own_text(cmark_node* node) {
  cmark_node_get_literal(node);
  for (cmark_node* child = cmark_node_first_child(node); child != nullptr;
       child = cmark_node_next(child)) {
    own_text(child);
  }
}

// Move the inlines of `paragraph` up to its first line break into a document of their own.
Document take_first_line(cmark_node* paragraph) {
  Document title(cmark_node_new(CMARK_NODE_DOCUMENT));
  cmark_node* line = cmark_node_new(CMARK_NODE_PARAGRAPH);
  cmark_node_append_child(title.get(), line);
  while (cmark_node* child = cmark_node_first_child(paragraph)) {
    const cmark_node_type type = cmark_node_get_type(child);
    if (type == CMARK_NODE_SOFTBREAK || type == CMARK_NODE_LINEBREAK) {
      cmark_node_free(child);
      break;
    }
    own_text(child);
    cmark_node_unlink(child);
    cmark_node_append_child(line, child);
  }
  return cmark_node_first_child(line) != nullptr ? std::move(title) : nullptr;
}

Span kind_span(cmark_node* quote, const std::string& kind, const SourceText& source) {
  const int line = cmark_node_get_start_line(quote);
  const std::size_t at = source.line(line).find("[!" + kind);
  const std::size_t begin = source.line_start(line) + (at == std::string_view::npos ? 0 : at + 2);
  return {begin, begin + kind.size()};
}

}  // namespace

const std::vector<std::string>& callout_kinds() {
  static const std::vector<std::string> kinds{
      "established", "derivation", "intuition", "pitfall", "open",    "exercise",  "challenge",
      "hint",        "solution",   "note",      "tip",     "warning", "important", "caution"};
  return kinds;
}

std::optional<Callout> take_callout(cmark_node* node, Reading& reading) {
  cmark_node* paragraph = cmark_node_first_child(node);
  if (paragraph == nullptr || cmark_node_get_type(paragraph) != CMARK_NODE_PARAGRAPH) return {};
  cmark_node* first = cmark_node_first_child(paragraph);
  if (first == nullptr || cmark_node_get_type(first) != CMARK_NODE_TEXT) return {};
  std::string_view text = cmark_node_get_literal(first);
  const std::size_t close = text.find(']');
  if (!text.starts_with("[!") || close == text.npos) return {};

  Callout callout;
  const std::string written(text.substr(2, close - 2));
  // GitHub writes its own five in capitals.
  std::transform(written.begin(), written.end(), std::back_inserter(callout.kind),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::vector<std::string>& kinds = callout_kinds();
  if (std::find(kinds.begin(), kinds.end(), callout.kind) == kinds.end()) {
    reading.error("E-callout-kind", kind_span(node, written, reading.source()),
                  "there is no callout `" + written + "`", suggest(callout.kind, kinds));
    return {};
  }
  callout.span = kind_span(node, written, reading.source());
  text.remove_prefix(close + 1);
  callout.folded = text.starts_with('-') || callout.kind == "solution" || callout.kind == "hint";
  if (text.starts_with('-')) text.remove_prefix(1);
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  if (text.empty()) {
    cmark_node_free(first);
  } else {
    cmark_node_set_literal(first, std::string(text).c_str());
  }
  callout.title = take_first_line(paragraph);
  if (cmark_node_first_child(paragraph) == nullptr) cmark_node_free(paragraph);
  return callout;
}

std::string source_in(cmark_node* callout) {
  std::string source;
  cmark_node* child = cmark_node_first_child(callout);
  for (; child != nullptr; child = cmark_node_next(child)) {
    const std::string text = plain_text(child);
    if (!text.starts_with("Source:") || text.size() < 9) continue;
    source = text.substr(text.find_first_not_of(' ', 7));
    for (cmark_node* part = cmark_node_first_child(child); part; part = cmark_node_next(part)) {
      if (cmark_node_get_type(part) != CMARK_NODE_LINK) continue;
      source += std::string(" <") + cmark_node_get_url(part) + ">";
    }
  }
  return source;
}

}  // namespace mjcourse
