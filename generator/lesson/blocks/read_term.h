// The glossary terms in a lesson's texts (term_syntax.h).
#pragma once

#include <cstddef>
#include <optional>

#include "lesson/blocks/block.h"
#include "lesson/syntax/reading.h"
#include "lesson/syntax/source_cursor.h"
#include "lesson/syntax/term_syntax.h"

namespace mjcourse {

// Cuts out the next term of `text`, which was `node`'s, at or behind byte `at` of its literal. Both
// `at` and the cursor move behind its `[[`. Reports those on the way that nothing closes.
std::optional<CutTerm> next_term(cmark_node* node, TextWithTerms& text, std::size_t& at,
                                 SourceCursor& cursor, Reading& reading);

struct ReadTerm {
  std::optional<TermUse> use;  // nothing (reported) where no term can stand
  std::size_t behind = 0;      // the name
};

// The cursor stands behind the term's `[[`, and moves to where its shown text begins.
ReadTerm read_term(const CutTerm& term, bool in_callout_title, SourceCursor& cursor,
                   Reading& reading);

}  // namespace mjcourse
