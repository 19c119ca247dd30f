// Markdown: cmark-gfm with GitHub's extensions and math.
//
// Enter at parse_markdown. The tree is cmark's own; math is two node types of ours, whose text no
// emphasis and no escape has touched.
#pragma once

#include <cmark-gfm.h>

#include <functional>
#include <memory>
#include <string>

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

// Whoever walks a tree goes down into it, so it ends where it would be nested deeper than
// kDeepestMarkdown: such a node loses its children, and `too_deep` is called with its line.
inline constexpr int kDeepestMarkdown = 200;
Document parse_markdown(const std::string& text,
                        const std::function<void(int line)>& too_deep = {});

// What a reader sees of `node` with all markup gone: text, code, and formulas as TeX.
std::string plain_text(cmark_node* node);

}  // namespace mjcourse
