#include "page/html/markdown_html.h"

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm/node.h>
#include <cmark-gfm/render.h>
#include <cmark-gfm/syntax_extension.h>

#include <cstdlib>
#include <map>
#include <memory>
#include <string_view>
#include <vector>

namespace mjcourse {
namespace {

// Lends the nodes that the writer takes an extension of ours, whose render function collects what
// is below the node and puts the writer's text in its place.
class Hooks {
 public:
  Hooks(cmark_node* root, const NodeWriter& writer)
      : writer_(writer), extension_(cmark_syntax_extension_new("page")) {
    cmark_syntax_extension_set_private(extension_, this, nullptr);
    cmark_syntax_extension_set_html_render_func(extension_, render);
    // cmark asks the extension of a node what it may contain.
    cmark_syntax_extension_set_can_contain_func(
        extension_, [](cmark_syntax_extension*, cmark_node*, cmark_node_type) { return 1; });
    lend(root);
  }
  Hooks(const Hooks&) = delete;
  Hooks& operator=(const Hooks&) = delete;
  ~Hooks() {
    for (const auto& [node, extension] : lent_) node->extension = extension;
    cmark_syntax_extension_free(cmark_get_default_mem_allocator(), extension_);
  }

 private:
  void lend(cmark_node* node) {
    if (writer_.takes(node)) {
      lent_[node] = node->extension;
      node->extension = extension_;
    }
    for (cmark_node* child = node->first_child; child != nullptr; child = child->next) lend(child);
  }

  static void render(cmark_syntax_extension* extension, cmark_html_renderer* renderer,
                     cmark_node* node, cmark_event_type event, int options) {
    static_cast<Hooks*>(cmark_syntax_extension_get_private(extension))
        ->render(renderer, node, event, options);
  }

  void render(cmark_html_renderer* renderer, cmark_node* node, cmark_event_type event,
              int options) {
    cmark_strbuf* html = renderer->html;
    // cmark sends no exit for its own leaves.
    const bool leaf = node->type == CMARK_NODE_CODE_BLOCK || node->type == CMARK_NODE_CODE ||
                      node->type == CMARK_NODE_TEXT;
    if (event == CMARK_EVENT_ENTER) starts_.push_back(html->size);
    cmark_syntax_extension* own = lent_[node];
    if (own != nullptr && own->html_render_func != nullptr) {  // a table writes itself first
      own->html_render_func(own, renderer, node, event, options);
    }
    if (event == CMARK_EVENT_ENTER && !leaf) return;
    const bufsize_t start = starts_.back();
    starts_.pop_back();
    const std::string inner(reinterpret_cast<char*>(html->ptr) + start,
                            static_cast<std::size_t>(html->size - start));
    cmark_strbuf_truncate(html, start);
    const std::string written = writer_.write(node, inner);
    cmark_strbuf_put(html, reinterpret_cast<const unsigned char*>(written.data()),
                     static_cast<bufsize_t>(written.size()));
  }

  const NodeWriter& writer_;
  cmark_syntax_extension* extension_;
  std::map<cmark_node*, cmark_syntax_extension*> lent_;  // with the extension that it had
  std::vector<bufsize_t> starts_;                        // where the open nodes' text begins
};

}  // namespace

std::string render_html(cmark_node* root, const NodeWriter& writer) {
  if (root == nullptr) return "";
  const Hooks hooks(root, writer);
  const std::unique_ptr<char, decltype(&std::free)> html(
      cmark_render_html(root, CMARK_OPT_UNSAFE, nullptr), std::free);
  return html.get();
}

std::string render_inline_html(cmark_node* root, const NodeWriter& writer) {
  std::string html = render_html(root, writer);
  while (html.ends_with('\n')) html.pop_back();
  const bool one_paragraph = html.starts_with("<p>") && html.find("<p>", 1) == html.npos;
  return one_paragraph && html.ends_with("</p>") ? html.substr(3, html.size() - 7) : html;
}

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace mjcourse
