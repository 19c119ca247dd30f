#include "lesson/syntax/markdown.h"

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm/parser.h>

#include <algorithm>
#include <mutex>
#include <set>
#include <string_view>
#include <vector>

#include "base/utf8.h"
#include "lesson/syntax/bounded_tables.h"
#include "lesson/syntax/math_syntax.h"
#include "lesson/syntax/quote_syntax.h"
#include "lesson/syntax/reference_losses.h"

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

// The nodes at the depth where the tree is to end that have children.
std::vector<cmark_node*> deepest_nodes(cmark_node* root) {
  std::vector<cmark_node*> deepest;
  const std::unique_ptr<cmark_iter, decltype(&cmark_iter_free)> walk(cmark_iter_new(root),
                                                                     cmark_iter_free);
  int depth = 0;
  for (cmark_event_type event; (event = cmark_iter_next(walk.get())) != CMARK_EVENT_DONE;) {
    cmark_node* node = cmark_iter_get_node(walk.get());
    if (cmark_node_first_child(node) == nullptr) continue;
    if (event == CMARK_EVENT_EXIT) {
      --depth;
    } else if (++depth == kDeepestMarkdown) {
      deepest.push_back(node);
    }
  }
  return deepest;
}

// Does a definition of a reference, `[label]: address "title"`, stand in `line`, behind the marks
// of quotes and lists?
bool may_define_reference(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t>*+-.)0123456789");
  return begin != line.npos && line[begin] == '[' && line.find("]:", begin) != line.npos;
}

// The line of a reference that may be copied too often; 0 for none. It ends before an empty line.
int excessive_reference(std::string_view text) {
  const auto brackets = static_cast<std::size_t>(std::count(text.begin(), text.end(), '['));
  const std::size_t most = kMostReferred / std::max<std::size_t>(brackets, 1);
  std::size_t begin = text.npos;  // of the definition that goes on
  int number = 1, first = 0;
  for (std::size_t at = 0; at < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    if (line.find_first_not_of(" \t\r>") == line.npos) begin = text.npos;
    if (begin == text.npos && may_define_reference(line)) {
      begin = at;
      first = number;
    }
    if (begin != text.npos && end - begin > most) return first;
    at = end + 1;
  }
  return 0;
}

struct FootnoteDefinition {
  std::string name;
  int line;
};

std::vector<FootnoteDefinition> footnotes_below(cmark_node* root) {
  std::vector<FootnoteDefinition> found;
  const std::unique_ptr<cmark_iter, decltype(&cmark_iter_free)> walk(cmark_iter_new(root),
                                                                     cmark_iter_free);
  for (cmark_event_type event; (event = cmark_iter_next(walk.get())) != CMARK_EVENT_DONE;) {
    cmark_node* node = cmark_iter_get_node(walk.get());
    const bool is_one = cmark_node_get_type(node) == CMARK_NODE_FOOTNOTE_DEFINITION;
    if (event != CMARK_EVENT_ENTER || !is_one) continue;
    const cmark_chunk& label = node->as.literal;
    found.push_back({std::string(reinterpret_cast<const char*>(label.data),
                                 static_cast<std::size_t>(label.len)),
                     cmark_node_get_start_line(node)});
  }
  return found;
}

// cmark drops a footnote that nothing refers to, and of two that have one name the second.
void note_dropped(const std::vector<FootnoteDefinition>& written, cmark_node* root,
                  Losses& losses) {
  std::set<int> kept;  // by their lines
  for (const FootnoteDefinition& one : footnotes_below(root)) kept.insert(one.line);
  std::set<std::string> names;
  for (const FootnoteDefinition& one : written) {
    const bool is_first = names.insert(lower_case_utf8(one.name)).second;
    if (kept.contains(one.line)) continue;
    const auto kind = is_first ? Loss::Kind::footnote : Loss::Kind::second_footnote;
    losses.push_back({kind, one.line, "", 0, 0, one.name});
  }
}

void cut(cmark_node* root, const Refuse& refuse) {
  for (cmark_node* node : deepest_nodes(root)) {
    if (refuse) refuse(Excess::depth, cmark_node_get_start_line(node));
    while (cmark_node* child = cmark_node_first_child(node)) cmark_node_free(child);
  }
}

}  // namespace

Document parse_markdown(const std::string& text, const Refuse& refuse, int first_line,
                        Losses* losses, const Typography& typography) {
  static const bool registered = [] {
    cmark_gfm_core_extensions_ensure_registered();
    BoundedTables::teach();
    return true;
  }();
  static_cast<void>(registered);
  const SyntaxPointer quotes = quote_syntax(typography.marks);
  // Raw HTML stays in the tree: what of it may stand there, raw_html.h says.
  const int options = CMARK_OPT_UNSAFE | CMARK_OPT_FOOTNOTES;
  const std::unique_ptr<cmark_parser, FreeParser> parser(
      cmark_parser_new(typography.smart ? options | CMARK_OPT_SMART : options));
  for (const char* name : {"table", "strikethrough", "autolink", "tasklist"}) {
    cmark_parser_attach_syntax_extension(parser.get(), cmark_find_syntax_extension(name));
  }
  cmark_parser_attach_syntax_extension(parser.get(), math_syntax());
  if (typography.smart) cmark_parser_attach_syntax_extension(parser.get(), quotes.get());
  const ReferenceLosses references(parser.get());
  Losses lost;
  const BoundedTables tables(lost);
  parser->line_number = first_line - 1;  // read so far
  if (const int line = excessive_reference(text); line == 0) {
    cmark_parser_feed(parser.get(), text.data(), text.size());
  } else if (refuse) {
    refuse(Excess::references, first_line + line - 1);
  }
  if (!text.ends_with('\n'))
    cmark_parser_feed(parser.get(), "\n", 1);  // the last line is read, too
  std::vector<FootnoteDefinition> footnotes;
  if (text.find("[^") != text.npos) footnotes = footnotes_below(parser->root);
  Document document = finish(parser.get());
  if (!footnotes.empty()) note_dropped(footnotes, document.get(), lost);
  references.note(text, first_line, lost);
  if (tables.refused_line() > 0 && refuse) refuse(Excess::cells, tables.refused_line());
  cut(document.get(), refuse);
  cmark_consolidate_text_nodes(document.get());
  if (losses != nullptr) *losses = std::move(lost);
  return document;
}

bool stands_in(cmark_node* node, cmark_node_type type) {
  while ((node = cmark_node_parent(node)) != nullptr) {
    if (cmark_node_get_type(node) == type) return true;
  }
  return false;
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
