#include "lesson/blocks/read_math.h"

#include <string>
#include <string_view>
#include <utility>

#include "lesson/syntax/doubtful_math.h"

namespace mjcourse {
namespace {

// Are there but blanks and the marks of quotes before `at` on its line?
bool starts_line(const SourceText& source, std::size_t at) {
  const std::size_t start = source.line_start(source.position(at).line);
  return source.text().substr(start, at - start).find_first_not_of(" \t>") ==
         std::string_view::npos;
}

// Does the text that begins at `at` stand on a line of its own, below other text of its paragraph?
bool begins_line_below_text(cmark_node* text, const SourceText& source, std::size_t at) {
  cmark_node* paragraph = cmark_node_parent(text);
  return paragraph != nullptr && starts_line(source, at) &&
         source.position(at).line > cmark_node_get_start_line(paragraph);
}

void warn_of_doubtful_math(const LocatedText& tex, Reading& reading) {
  const std::string_view text = reading.source().text();
  const Span span = tex.span();
  const auto is_dollar = [&](std::size_t at) { return at < text.size() && text[at] == '$'; };
  if (!is_dollar(span.begin - 1) || !is_dollar(span.end)) return;  // it was not found
  const char before = span.begin > 1 ? text[span.begin - 2] : '\0';
  if (!is_doubtful_math(before, tex.text, text.substr(span.end + 1))) return;
  reading.warning(
      "W-math-doubtful", {span.begin - 1, span.end + 1},
      "what stands between these two dollars is read as a formula, though it looks like text",
      "for a dollar as text, write `\\$`, or code; for the formula, set it apart from "
      "the words around it");
}

}  // namespace

Math read_math(cmark_node* node, SourceCursor& cursor, MathState& state, Reading& reading) {
  const MathText& math = math_text(node);
  const std::string dollars = math.display ? "$$" : "$";
  const LocatedText opened = cursor.find(dollars + math.tex);
  const LocatedText tex = opened.part(dollars.size(), opened.text.size());
  const bool is_end = math.display && std::exchange(state.is_cut, false);
  if (!math.closed && !is_end) {
    reading.error("E-math-unclosed", {tex.span().begin - 2, tex.span().begin},
                  "this `$$` is never closed", "end the formula with `$$`");
  }
  if (!math.behind.empty()) {
    reading.error("E-math-behind", cursor.find(math.behind).span(),
                  "text follows the `$$` that closes the formula", "begin it on a line of its own");
  }
  if (!math.display) warn_of_doubtful_math(tex, reading);
  return {tex, math.display};
}

void refuse_unclosed_math(cmark_node* text, SourceCursor cursor, bool in_document, MathState& state,
                          Reading& reading) {
  if (std::string_view(cmark_node_get_literal(text)).find("$$") == std::string_view::npos) return;
  const SourceText& source = reading.source();
  const Span span = cursor.find("$$").span();
  const bool below_text = in_document && begins_line_below_text(text, source, span.begin);
  // Its end is the second that is not closed: of a formula that a list or a quote cut in two.
  const bool is_end = std::exchange(state.is_cut, below_text && !state.is_cut);
  if (is_end && starts_line(source, span.begin)) return;
  reading.error(
      "E-math-unclosed", span, "this `$$` is never closed",
      below_text
          ? "leave an empty line above it: right below text, the formula ends where a list, a "
            "quote "
            "or a heading may begin, at a line with `-`, `+`, `>` or `#`; then end it with `$$`"
          : "end the formula with `$$`; for dollars as text write `\\$\\$`");
}

}  // namespace mjcourse
