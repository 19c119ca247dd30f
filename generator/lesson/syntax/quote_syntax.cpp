#include "lesson/syntax/quote_syntax.h"

#include <cmark-gfm/inlines.h>
#include <cmark-gfm/node.h>
#include <cmark-gfm/parser.h>
#include <cmark-gfm/syntax_extension.h>
#include <re2/re2.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace mjcourse {
namespace {

std::string_view literal_of(cmark_node* node) {
  const cmark_chunk& literal = node->as.literal;
  return {reinterpret_cast<const char*>(literal.data), static_cast<std::size_t>(literal.len)};
}

void write(cmark_node* quote, std::string_view mark) {
  cmark_node_set_literal(quote, std::string(mark).c_str());
}

// Do words go on right behind the `'`, as in "don't"?
bool is_within_word(cmark_node* quote) {
  cmark_node* next = quote->next;
  if (next == nullptr || next->type != CMARK_NODE_TEXT) return false;
  const std::string_view text = literal_of(next);
  static const RE2 word(R"(^[\pL\pN])");
  return RE2::PartialMatch(re2::StringPiece(text.data(), text.size()), word);
}

// cmark takes the ' of `qvel`'s for one that opens a quote, as code, a formula or emphasis before
// it ends with punctuation.
bool is_behind_a_thing(cmark_node* quote) {
  cmark_node* before = quote->prev;
  if (before == nullptr) return false;
  const auto type = static_cast<cmark_node_type>(before->type);
  if (type == CMARK_NODE_HTML_INLINE) return literal_of(before).starts_with("</");
  return type != CMARK_NODE_TEXT && type != CMARK_NODE_SOFTBREAK && type != CMARK_NODE_LINEBREAK;
}

// cmark found that `closer` may close what `opener` opens. Gives where it goes on.
delimiter* take_pair(cmark_syntax_extension* self, cmark_parser*, cmark_inline_parser*,
                     delimiter* opener, delimiter* closer) {
  const auto& marks = *static_cast<const QuotationMarks*>(cmark_syntax_extension_get_private(self));
  const bool is_inner = closer->delim_char == '\'';
  if (is_inner && is_within_word(closer->inl_text)) return closer->next;  // both may be apostrophes
  opener->can_open = 0;
  if (is_inner && is_behind_a_thing(opener->inl_text)) return closer;  // for the opener before it
  closer->can_open = 0;
  write(opener->inl_text, is_inner ? marks.inner_open : marks.open);
  write(closer->inl_text, is_inner ? marks.inner_close : marks.close);
  return closer->next;
}

}  // namespace

SyntaxPointer quote_syntax(const QuotationMarks& marks) {
  SyntaxPointer syntax(cmark_syntax_extension_new("quotes"));
  cmark_mem* memory = cmark_get_default_mem_allocator();
  cmark_llist* characters = nullptr;
  for (const char quote : {'"', '\''}) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): cmark's way of writing a list of characters
    void* const character = reinterpret_cast<void*>(static_cast<std::uintptr_t>(quote));
    characters = cmark_llist_append(memory, characters, character);
  }
  cmark_syntax_extension_set_special_inline_chars(syntax.get(), characters);
  cmark_syntax_extension_set_private(syntax.get(), const_cast<QuotationMarks*>(&marks), nullptr);
  cmark_syntax_extension_set_match_inline_func(
      syntax.get(),
      [](cmark_syntax_extension*, cmark_parser*, cmark_node*, unsigned char,
         cmark_inline_parser*) -> cmark_node* { return nullptr; });
  cmark_syntax_extension_set_inline_from_delim_func(syntax.get(), take_pair);
  return syntax;
}

}  // namespace mjcourse
