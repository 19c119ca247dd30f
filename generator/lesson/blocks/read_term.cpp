#include "lesson/blocks/read_term.h"

#include <string>
#include <utility>

#include "base/utf8.h"

namespace mjcourse {
namespace {

// Was a term meant by the `[[` at `at` of a text, whose `]]` is missing? Only a word follows it
// then.
bool looks_like_term(cmark_node* text, const std::string& literal, std::size_t at) {
  if (at + 2 < literal.size()) return is_letter(literal[at + 2]);
  cmark_node* next = cmark_node_next(text);
  return next != nullptr && cmark_node_get_type(next) == CMARK_NODE_CODE;
}

// What a term may not stand in, since it is a link itself; "" for none.
std::string link_around(cmark_node* node) {
  for (; node != nullptr; node = cmark_node_parent(node)) {
    if (cmark_node_get_type(node) == CMARK_NODE_LINK) return "the text of a link";
    if (cmark_node_get_type(node) == CMARK_NODE_HEADING) return "a heading";
  }
  return "";
}

// Moves the cursor behind the next `[[`. False when a backslash makes it mere text.
bool pass_brackets(SourceCursor& cursor) {
  const std::string& text = cursor.text.text;
  for (std::size_t at = cursor.at; at < text.size(); ++at) {
    for (const char* escaped : {"\\[\\[", "\\[[", "[\\["}) {
      if (text.compare(at, std::string(escaped).size(), escaped) != 0) continue;
      cursor.at = at + std::string(escaped).size();
      return false;
    }
    if (text.compare(at, 2, "[[") == 0) {
      cursor.at = at + 2;
      return true;
    }
    if (text[at] == '\\') ++at;
  }
  return true;
}

}  // namespace

std::optional<CutTerm> next_term(cmark_node* node, TextWithTerms& text, std::size_t& at,
                                 SourceCursor& cursor, Reading& reading) {
  // A term that ends in another node takes the rest of this one.
  while ((at = text.literal().find("[[", at)) != std::string::npos) {
    const std::size_t opened = std::exchange(at, at + 2);
    const bool plain = pass_brackets(cursor);
    if (!plain || (opened > 0 && is_word_character(text.literal()[opened - 1]))) continue;
    if (std::optional<CutTerm> term = text.cut(opened)) return term;
    if (!looks_like_term(node, text.literal(), opened)) continue;
    const Span brackets = cursor.text.span(cursor.at - 2, cursor.at);
    reading.error(
        "E-term-unclosed", brackets, "no `]]` closes this term on its line",
        "write `[[term]]`, in a table `[[term\\|shown text]]`; `\\[[` for brackets as text");
  }
  return std::nullopt;
}

ReadTerm read_term(const CutTerm& term, bool in_callout_title, SourceCursor& cursor,
                   Reading& reading) {
  const std::string& text = cursor.text.text;
  std::size_t end = cursor.at;
  while (end < text.size() && text[end] != '|' && text[end] != '\n' &&
         text.compare(end, 2, "]]") != 0) {
    ++end;
  }
  if (end > cursor.at && text[end - 1] == '\\') --end;  // `\|`, in a table
  LocatedText name = cursor.text.part(cursor.at, end);
  // What is shown stands behind the bar, or is the name itself.
  if (text.compare(end, 1, "|") == 0 || text.compare(end, 2, "\\|") == 0) cursor.at = end;
  std::string around = link_around(cmark_node_parent(term.node));
  if (in_callout_title) around = "a callout's title";  // which may fold the callout
  if (around.empty()) return {TermUse{std::move(name), term_key(term.name)}, end};
  reading.error("E-term-place", name.span(), "a term cannot stand in " + around,
                "a term is a link itself: put it where the text first speaks of it");
  return {std::nullopt, end};
}

}  // namespace mjcourse
