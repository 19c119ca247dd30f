#include "lesson/syntax/math_syntax.h"

#include <cmark-gfm/parser.h>
#include <cmark-gfm/syntax_extension.h>

#include <optional>
#include <string>
#include <string_view>

#include "base/utf8.h"
#include "lesson/syntax/inline_length.h"
#include "lesson/syntax/markdown.h"

namespace mjcourse {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

void attach(cmark_node* node, MathText math) {
  cmark_node_set_user_data(node, new MathText(std::move(math)));
  cmark_node_set_user_data_free_func(
      node, [](cmark_mem*, void* data) { delete static_cast<MathText*>(data); });
}

MathText& math_of(cmark_node* node) {
  return *static_cast<MathText*>(cmark_node_get_user_data(node));
}

// The next `fence` in `text` from `from` on that no backslash escapes.
std::size_t find_unescaped(std::string_view text, std::string_view fence, std::size_t from) {
  for (std::size_t at = from; at < text.size(); ++at) {
    if (text[at] == '\\') {
      ++at;
    } else if (text.substr(at).starts_with(fence)) {
      return at;
    }
  }
  return std::string_view::npos;
}

// Else each of many dollars behind a brace that nothing closes would look at all that follows.
constexpr int kMostInnerDollars = 40;

// The dollar that closes the formula of `text`, counting braces as KaTeX does, so that one within
// `\text{…}` does not. Where they do not come out even, the next dollar, and KaTeX says what is
// wrong.
std::size_t find_closing_dollar(std::string_view text) {
  int depth = 0, inner = 0;
  for (std::size_t at = 1; at < text.size() && inner <= kMostInnerDollars; ++at) {
    const char c = text[at];
    if (c == '\\') {
      ++at;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}') {
      --depth;
    } else if (c == '$' && depth <= 0) {
      return at;
    } else if (c == '$') {
      ++inner;
    }
  }
  return find_unescaped(text, "$", 1);
}

struct InlineMath {
  MathText math;
  std::size_t length = 0;  // with its dollars
};

// The math that `text`, which starts with a dollar, opens; nothing when that dollar is text.
std::optional<InlineMath> scan_inline(std::string_view text) {
  if (text.starts_with("$$")) {
    const std::size_t close = find_unescaped(text, "$$", 2);
    if (close == text.npos || close == 2) return std::nullopt;
    return InlineMath{{std::string(text.substr(2, close - 2)), true}, close + 2};
  }
  if (text.size() < 2 || is_space(text[1])) return std::nullopt;
  const std::size_t close = find_closing_dollar(text);
  if (close == text.npos || is_space(text[close - 1])) return std::nullopt;
  const bool digit_follows = close + 1 < text.size() && is_digit(text[close + 1]);
  if (digit_follows) return std::nullopt;
  return InlineMath{{std::string(text.substr(1, close - 1))}, close + 1};
}

cmark_node* match_inline(cmark_syntax_extension* self, cmark_parser* parser, cmark_node*,
                         unsigned char character, cmark_inline_parser* inlines) {
  if (character != '$') return nullptr;  // cmark asks at other extensions' characters too
  const cmark_chunk* chunk = cmark_inline_parser_get_chunk(inlines);
  const int offset = cmark_inline_parser_get_offset(inlines);
  const std::string_view rest(reinterpret_cast<const char*>(chunk->data) + offset,
                              static_cast<std::size_t>(chunk->len - offset));
  std::optional<InlineMath> found = scan_inline(rest);
  if (!found) return nullptr;
  cmark_node* node = cmark_node_new_with_mem_and_ext(math_inline_type(), parser->mem, self);
  attach(node, std::move(found->math));
  node->start_line = node->end_line = cmark_inline_parser_get_line(inlines);
  cmark_inline_parser_set_offset(inlines, offset + static_cast<int>(found->length));
  return node;
}

// The rest of the parser's line without its end.
std::string_view rest_of_line(cmark_parser* parser, unsigned char* input, int length) {
  const int offset = cmark_parser_get_offset(parser);
  std::string_view rest(reinterpret_cast<char*>(input) + offset,
                        static_cast<std::size_t>(length - offset));
  while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
  return rest;
}

// Leave nothing of the line but its end, so that cmark adds no paragraph to the block.
void consume_line(cmark_parser* parser, unsigned char* input, int length) {
  cmark_parser_advance_offset(parser, reinterpret_cast<char*>(input),
                              length - 1 - cmark_parser_get_offset(parser), 0);
}

cmark_node* open_block(cmark_syntax_extension* self, int indented, cmark_parser* parser,
                       cmark_node* parent, unsigned char* input, int length) {
  const cmark_node_type type = cmark_node_get_type(parent);
  if (indented || type == CMARK_NODE_PARAGRAPH || type == math_block_type()) return nullptr;
  std::string_view line = rest_of_line(parser, input, length);
  while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
  if (!line.starts_with("$$")) return nullptr;
  const std::size_t close = find_unescaped(line, "$$", 2);
  // Text after the formula on the same line: a paragraph that begins with math.
  if (close != line.npos && close + 2 != line.size()) return nullptr;
  cmark_node* node = cmark_parser_add_child(parser, parent, math_block_type(),
                                            cmark_parser_get_first_nonspace(parser) + 1);
  if (node == nullptr) return nullptr;
  cmark_node_set_syntax_extension(node, self);
  const bool closed = close != line.npos;
  attach(node, {std::string(line.substr(2, closed ? close - 2 : line.npos)), true, closed, ""});
  consume_line(parser, input, length);
  return node;
}

// Whether the line still belongs to the open block; it is taken here.
int continue_block(cmark_syntax_extension*, cmark_parser* parser, unsigned char* input, int length,
                   cmark_node* block) {
  if (cmark_node_get_type(block) != math_block_type()) return 0;
  MathText& math = math_of(block);
  if (math.closed) return 0;
  const std::string_view line = rest_of_line(parser, input, length);
  const std::size_t close = find_unescaped(line, "$$", 0);
  math.closed = close != line.npos;
  math.tex += "\n";
  math.tex += line.substr(0, close);
  if (math.closed) math.behind = line.substr(close + 2);
  consume_line(parser, input, length);
  return 1;
}

const char* type_string(cmark_syntax_extension*, cmark_node* node) {
  return cmark_node_get_type(node) == math_inline_type() ? "math" : "math_block";
}

int contains_nothing(cmark_syntax_extension*, cmark_node*, cmark_node_type) {
  return 0;
}

// A table's cell refuses what it does not know: let formulas stand wherever text may.
void teach_tables() {
  cmark_syntax_extension* table = cmark_find_syntax_extension("table");
  static const cmark_can_contain_func known = table->can_contain_func;
  cmark_syntax_extension_set_can_contain_func(
      table, [](cmark_syntax_extension* self, cmark_node* node, cmark_node_type child) {
        return known(self, node, child == math_inline_type() ? CMARK_NODE_TEXT : child);
      });
}

}  // namespace

cmark_node_type math_inline_type() {
  static const cmark_node_type type = cmark_syntax_extension_add_node(1);
  return type;
}

cmark_node_type math_block_type() {
  static const cmark_node_type type = cmark_syntax_extension_add_node(0);
  return type;
}

std::size_t math_length(std::string_view text) {
  const std::optional<InlineMath> found = scan_inline(text);
  return found ? found->length : 0;
}

const MathText& math_text(cmark_node* math) {
  return math_of(math);
}

cmark_syntax_extension* math_syntax() {
  static cmark_syntax_extension* const extension = [] {
    cmark_syntax_extension* made = cmark_syntax_extension_new("math");
    cmark_mem* memory = cmark_get_default_mem_allocator();
    // A list of characters, in cmark's way of writing one.
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    const auto dollar = reinterpret_cast<void*>(static_cast<std::uintptr_t>('$'));
    cmark_syntax_extension_set_special_inline_chars(made,
                                                    cmark_llist_append(memory, nullptr, dollar));
    cmark_syntax_extension_set_match_inline_func(made, match_inline);
    cmark_syntax_extension_set_open_block_func(made, open_block);
    cmark_syntax_extension_set_match_block_func(made, continue_block);
    cmark_syntax_extension_set_get_type_string_func(made, type_string);
    cmark_syntax_extension_set_can_contain_func(made, contains_nothing);
    teach_tables();
    return made;
  }();
  return extension;
}

}  // namespace mjcourse
