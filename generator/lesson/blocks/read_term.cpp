// Texts of a lesson, and the glossary terms in them.
#include <algorithm>

#include "base/utf8.h"
#include "lesson/blocks/lesson_reader.h"
#include "lesson/blocks/read_image.h"
#include "lesson/syntax/term_syntax.h"

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

}  // namespace

// Gives the node to go on with.
cmark_node* LessonReader::read_text(cmark_node* node, Region& region) {
  refuse_unclosed_math(node, region);
  refuse_blank_in_name(node, region.text, region.cursor, reading_);
  TextWithTerms text(node);
  // A term that ends in another node takes the rest of this one.
  for (std::size_t at = 0; (at = text.literal().find("[[", at)) != std::string::npos; at += 2) {
    const bool plain = pass_brackets(region);
    if (!plain || (at > 0 && is_word_character(text.literal()[at - 1]))) continue;
    if (const std::optional<CutTerm> term = text.cut(at)) {
      read_term(*term, region);
      continue;
    }
    if (!looks_like_term(node, text.literal(), at)) continue;
    const Span brackets = region.text.span(region.cursor - 2, region.cursor);
    reading_.error(
        "E-term-unclosed", brackets, "no `]]` closes this term on its line",
        "write `[[term]]`, in a table `[[term\\|shown text]]`; `\\[[` for brackets as text");
  }
  return text.finish();
}

// Move the region's cursor behind the next `[[`. False when a backslash makes it mere text.
bool LessonReader::pass_brackets(Region& region) {
  const std::string& text = region.text.text;
  for (std::size_t at = region.cursor; at < text.size(); ++at) {
    for (const char* escaped : {"\\[\\[", "\\[[", "[\\["}) {
      if (text.compare(at, std::string(escaped).size(), escaped) != 0) continue;
      region.cursor = at + std::string(escaped).size();
      return false;
    }
    if (text.compare(at, 2, "[[") == 0) {
      region.cursor = at + 2;
      return true;
    }
    if (text[at] == '\\') ++at;
  }
  return true;
}

// The cursor stands behind the term's `[[`.
void LessonReader::read_term(const CutTerm& term, Region& region) {
  if (is_too_much(region)) return;
  const std::string& text = region.text.text;
  std::size_t end = region.cursor;
  while (end < text.size() && text[end] != '|' && text[end] != '\n' &&
         text.compare(end, 2, "]]") != 0) {
    ++end;
  }
  if (end > region.cursor && text[end - 1] == '\\') --end;  // `\|`, in a table
  const LocatedText name = region.text.part(region.cursor, end);
  // What is shown stands behind the bar, or is the name itself.
  if (text.compare(end, 1, "|") == 0 || text.compare(end, 2, "\\|") == 0) region.cursor = end;
  std::string around = link_around(cmark_node_parent(term.node));
  if (in_callout_title_) around = "a callout's title";  // which may fold the callout
  if (!around.empty()) {
    reading_.error("E-term-place", name.span(), "a term cannot stand in " + around,
                   "a term is a link itself: put it where the text first speaks of it");
  } else {
    add(term.node, TermUse{name, term_key(term.name)});
  }
  walk_children(term.node, region);
  region.cursor = std::max(region.cursor, end);
}

}  // namespace mjcourse
