// The Markdown of glossary terms: `[[term]]` and `[[term|shown text]]`.
//
// cmark knows no such thing and leaves it as text, maybe with code or emphasis in between. So a
// term is cut out of its line's texts into a node of its own: a link without an address, since a
// table's cell may hold nothing else that has children. What stands in code and in formulas is no
// text, and so no term; neither is `[[` that a word character precedes (`a[[0]]`), or that has
// brackets in it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "lesson/markdown.h"

namespace mjcourse {

struct CutTerm {
  cmark_node* node;  // holds what is shown
  std::string name;  // each stretch of blanks as one
};

// Cut out the term that opens at byte `at` of a text node, where `[[` stands. Nothing, and the tree
// as it was, when no `]]` closes it on its line.
std::optional<CutTerm> cut_term(cmark_node* text, std::size_t at);

// What the names of terms are matched by: whatever their case, their blanks alike.
std::string term_key(const std::string& name);

}  // namespace mjcourse
