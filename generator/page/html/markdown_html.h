// Markdown trees as HTML: cmark's own renderer, with our hands on some of its nodes.
#pragma once

#include <functional>
#include <string>

#include "lesson/syntax/markdown.h"

namespace mjcourse {

// What to write for a node instead of what cmark would.
struct NodeWriter {
  // Asked once for each node: does this writer write it?
  std::function<bool(cmark_node*)> takes;
  // Gets what cmark made of the node's children ("" for a leaf) and gives the node's HTML.
  std::function<std::string(cmark_node*, const std::string& inner)> write;
};

// The HTML of `root` and all below it.
std::string render_html(cmark_node* root, const NodeWriter& writer);

// The same without the `<p>` around it, where that is all there is: for titles, labels, options.
std::string render_inline_html(cmark_node* root, const NodeWriter& writer);

// `text` with &, <, > and " made safe for HTML.
std::string escape_html(std::string_view text);

}  // namespace mjcourse
