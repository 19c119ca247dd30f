// The Markdown of glossary terms: `[[term]]` and `[[term|shown text]]`.
//
// cmark knows no such thing and leaves it as text, maybe with code or emphasis in between. So a
// term is cut out of its line's texts into a node of its own: a link without an address, since a
// table's cell may hold nothing else that has children. What stands in code and in formulas is no
// text, and so no term; neither is `[[` that a word character precedes (`a[[0]]`), or that has
// brackets in it.
// Tested by tests/generator/lesson/blocks/read_term_test.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "lesson/syntax/markdown.h"

namespace mjcourse {

struct CutTerm {
  cmark_node* node;  // holds what is shown
  std::string name;  // each stretch of blanks as one
};

// A text node of which terms are cut. What stands before a term becomes a node of its own, so the
// rest is written once, however many terms there are.
class TextWithTerms {
 public:
  explicit TextWithTerms(cmark_node* text) : text_(text), literal_(cmark_node_get_literal(text)) {}

  const std::string& literal() const { return literal_; }

  // Cut out the term that opens at byte `at` of the literal, where `[[` stands. Nothing, and the
  // tree as it was, when no `]]` closes it on its line.
  std::optional<CutTerm> cut(std::size_t at);

  // Write what is left behind the last term. The node to go on with: the one behind all that was
  // looked at.
  cmark_node* finish();

 private:
  CutTerm cut_here(std::size_t at, const struct TermExtent& extent);
  CutTerm cut_beyond(std::size_t at, const struct TermExtent& extent);

  cmark_node* text_;
  std::string literal_;
  std::size_t begin_ = 0;         // of what is still in `text_`
  cmark_node* beyond_ = nullptr;  // a term that ends in another node
};

// What the names of terms are matched by: whatever their case, their blanks alike.
std::string term_key(const std::string& name);

}  // namespace mjcourse
