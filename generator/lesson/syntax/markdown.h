// Markdown: cmark-gfm with GitHub's extensions and math.
//
// Enter at parse_markdown. The tree is cmark's own; math is two node types of ours, whose text no
// emphasis and no escape has touched.
#pragma once

#include <cmark-gfm.h>

#include <functional>
#include <memory>
#include <string>

#include "lesson/syntax/loss.h"
#include "lesson/syntax/typography.h"

namespace mjcourse {

struct FreeNode {
  void operator()(cmark_node* node) const { cmark_node_free(node); }
};

// Owns a tree; empty where an optional text was left out.
using Document = std::unique_ptr<cmark_node, FreeNode>;

// The node types of `$…$` and of a `$$` block.
cmark_node_type math_inline_type();
cmark_node_type math_block_type();

// What stands between the dollars of a math node.
struct MathText {
  std::string tex;
  bool display = false;
  bool closed = true;    // false for a `$$` block that the text's end cut off
  std::string behind{};  // what follows the closing `$$` of a block on its line, and may not
};
const MathText& math_text(cmark_node* math);

// What a text has more of than is read.
enum class Excess {
  // A walk over a tree goes down into it, so it ends where it would be nested deeper than
  // kDeepestMarkdown: such a node loses its children.
  depth,
  // A row has a cell in each column, also where nothing stands: ten bytes a row make a hundred
  // million of them. No table begins, and none goes on, where there would be more than kMostCells.
  cells,
  // A reference's address and title are copied to each link that names it. Where that may be more
  // than kMostReferred bytes, nothing of the text is read.
  references,
};
inline constexpr int kDeepestMarkdown = 200;
inline constexpr int kMostCells = 10'000;  // in one text
inline constexpr int kMostColumns = 200;   // of a table
inline constexpr std::size_t kMostReferred = 64 << 20;

// The tree's lines are counted from `first_line`. `refuse` is called with the line of each excess,
// and what is lost is added to `losses`.
using Refuse = std::function<void(Excess excess, int line)>;
Document parse_markdown(const std::string& text, const Refuse& refuse = {}, int first_line = 1,
                        Losses* losses = nullptr, const Typography& typography = {});

// Does `node` stand in one of the type?
bool stands_in(cmark_node* node, cmark_node_type type);

// What a reader sees of `node` with all markup gone: text, code, and formulas as TeX.
std::string plain_text(cmark_node* node);

}  // namespace mjcourse
