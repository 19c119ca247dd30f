#include "lesson/markdown.h"

#include <cmark-gfm-core-extensions.h>

#include <mutex>

#include "lesson/math_syntax.h"

namespace mjcourse {
namespace {

struct FreeParser {
  void operator()(cmark_parser* parser) const { cmark_parser_free(parser); }
};

// While cmark reads inlines, the characters at which extensions look stand in a table that all its
// parsers share, and leave it at the end: so only one may read them at a time.
Document finish(cmark_parser* parser) {
  static std::mutex mutex;
  const std::lock_guard guard(mutex);
  return Document(cmark_parser_finish(parser));
}

}  // namespace

Document parse_markdown(const std::string& text) {
  static const bool registered = [] {
    cmark_gfm_core_extensions_ensure_registered();
    return true;
  }();
  static_cast<void>(registered);
  // Raw HTML passes: lessons are the course's own text.
  const std::unique_ptr<cmark_parser, FreeParser> parser(
      cmark_parser_new(CMARK_OPT_UNSAFE | CMARK_OPT_FOOTNOTES | CMARK_OPT_SMART));
  for (const char* name : {"table", "strikethrough", "autolink", "tasklist"}) {
    cmark_parser_attach_syntax_extension(parser.get(), cmark_find_syntax_extension(name));
  }
  cmark_parser_attach_syntax_extension(parser.get(), math_syntax());
  cmark_parser_feed(parser.get(), text.data(), text.size());
  Document document = finish(parser.get());
  cmark_consolidate_text_nodes(document.get());
  return document;
}

std::string plain_text(cmark_node* node) {
  const cmark_node_type type = cmark_node_get_type(node);
  if (type == CMARK_NODE_TEXT || type == CMARK_NODE_CODE) return cmark_node_get_literal(node);
  if (type == CMARK_NODE_SOFTBREAK || type == CMARK_NODE_LINEBREAK) return " ";
  if (type == math_inline_type() || type == math_block_type()) return math_text(node).tex;
  std::string text;
  for (cmark_node* child = cmark_node_first_child(node); child != nullptr;
       child = cmark_node_next(child)) {
    text += plain_text(child);
  }
  return text;
}

}  // namespace mjcourse
