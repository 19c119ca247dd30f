#include "lesson/syntax/term_syntax.h"

#include <algorithm>
#include <string_view>

#include "base/running_text.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

bool may_stand_in_term(cmark_node* node) {
  const cmark_node_type type = cmark_node_get_type(node);
  return type == CMARK_NODE_TEXT || type == CMARK_NODE_CODE || type == CMARK_NODE_EMPH ||
         type == CMARK_NODE_STRONG || type == math_inline_type();
}

cmark_node* text_node(const std::string& literal) {
  cmark_node* node = cmark_node_new(CMARK_NODE_TEXT);
  cmark_node_set_literal(node, literal.c_str());
  return node;
}

// Take the name and its bar away from what is shown, unless nothing stands behind the bar.
void remove_name(cmark_node* term) {
  while (cmark_node* first = cmark_node_first_child(term)) {
    std::string literal;
    if (cmark_node_get_type(first) == CMARK_NODE_TEXT) literal = cmark_node_get_literal(first);
    cmark_node_free(first);
    const std::size_t bar = literal.find('|');
    if (bar == literal.npos) continue;
    const std::size_t shown = literal.find_first_not_of(' ', bar + 1);
    if (shown != literal.npos) cmark_node_prepend_child(term, text_node(literal.substr(shown)));
    return;
  }
}

}  // namespace

// Where a term ends, and how it is called.
struct TermExtent {
  cmark_node* last = nullptr;  // the text that has its `]]`
  std::size_t close = 0;       // the offset of that
  bool has_bar = false;
  std::string name;
};

namespace {

std::optional<TermExtent> measure(cmark_node* text, std::string_view first, std::size_t at) {
  TermExtent extent;
  for (cmark_node* node = text; node != nullptr; node = cmark_node_next(node)) {
    if (!may_stand_in_term(node)) return std::nullopt;
    if (cmark_node_get_type(node) != CMARK_NODE_TEXT) {
      if (!extent.has_bar) extent.name += plain_text(node);
      continue;
    }
    const std::string_view literal = node == text ? first : cmark_node_get_literal(node);
    const std::size_t from = node == text ? at + 2 : 0;
    const std::size_t close = std::min(literal.find_first_of("[]", from), literal.size());
    const std::string_view piece = literal.substr(from, close - from);
    if (!extent.has_bar) extent.name += piece.substr(0, piece.find('|'));
    extent.has_bar = extent.has_bar || piece.find('|') != piece.npos;
    if (close == literal.size()) continue;
    if (!literal.substr(close).starts_with("]]")) return std::nullopt;
    extent.last = node;
    extent.close = close;
    extent.name = with_single_blanks(extent.name);
    return extent.name.empty() ? std::nullopt : std::optional(extent);
  }
  return std::nullopt;
}

}  // namespace

std::optional<CutTerm> TextWithTerms::cut(std::size_t at) {
  const std::optional<TermExtent> extent = measure(text_, literal_, at);
  if (!extent) return std::nullopt;
  CutTerm term = extent->last == text_ ? cut_here(at, *extent) : cut_beyond(at, *extent);
  if (extent->has_bar) remove_name(term.node);
  if (plain_text(term.node).empty()) cmark_node_append_child(term.node, text_node(extent->name));
  return term;
}

CutTerm TextWithTerms::cut_here(std::size_t at, const TermExtent& extent) {
  cmark_node* term = cmark_node_new(CMARK_NODE_LINK);
  cmark_node_insert_before(text_, text_node(literal_.substr(begin_, at - begin_)));
  cmark_node_insert_before(text_, term);
  cmark_node_append_child(term, text_node(literal_.substr(at + 2, extent.close - at - 2)));
  begin_ = extent.close + 2;
  return {term, extent.name};
}

CutTerm TextWithTerms::cut_beyond(std::size_t at, const TermExtent& extent) {
  const std::string closing = cmark_node_get_literal(extent.last);
  cmark_node* term = cmark_node_new(CMARK_NODE_LINK);
  cmark_node_insert_after(extent.last, text_node(closing.substr(extent.close + 2)));
  cmark_node_insert_after(extent.last, term);
  cmark_node_append_child(term, text_node(literal_.substr(at + 2)));
  for (cmark_node* inner = cmark_node_next(text_); inner != term;) {
    cmark_node* next = cmark_node_next(inner);
    cmark_node_append_child(term, inner);
    inner = next;
  }
  cmark_node_set_literal(extent.last, closing.substr(0, extent.close).c_str());
  literal_.resize(at);
  beyond_ = term;
  return {term, extent.name};
}

cmark_node* TextWithTerms::finish() {
  if (begin_ > 0 || beyond_ != nullptr) {
    cmark_node_set_literal(text_, literal_.substr(begin_).c_str());
  }
  return cmark_node_next(beyond_ == nullptr ? text_ : beyond_);
}

std::string term_key(const std::string& name) {
  return lower_case_utf8(with_single_blanks(name));
}

}  // namespace mjcourse
