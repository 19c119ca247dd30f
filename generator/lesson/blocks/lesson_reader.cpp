#include "lesson/blocks/lesson_reader.h"

#include <cmark-gfm/node.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "lesson/blocks/callout.h"
#include "lesson/blocks/fence.h"
#include "lesson/blocks/read_demo.h"
#include "lesson/blocks/read_fence.h"
#include "lesson/blocks/read_image.h"
#include "lesson/blocks/read_link.h"
#include "lesson/blocks/read_losses.h"
#include "lesson/blocks/read_mere_text.h"
#include "lesson/blocks/read_output.h"
#include "lesson/blocks/read_term.h"
#include "lesson/blocks/read_unchecked.h"
#include "lesson/blocks/read_value.h"
#include "lesson/syntax/picture_name.h"

namespace mjcourse {
namespace {

constexpr int kMostParts = 10'000;

// All nodes of the trees but text, the ends of lines, and cells, of which the tables keep count.
bool is_part(cmark_node* node) {
  return cmark_node_get_type(node) != CMARK_NODE_SOFTBREAK &&
         !std::string_view(cmark_node_get_type_string(node)).starts_with("table_");
}

}  // namespace

void LessonReader::read_document() {
  in_document_ = true;
  const LocatedText whole = located(source(), {0, source().text().size()});
  SourceCursor cursor{whole, 0};
  walk(lesson_.document.get(), cursor);
  in_document_ = false;
}

void LessonReader::refuse_excess(Excess excess, Span span) {
  if (excess == Excess::depth) {
    reading_.error("E-markdown-depth", span,
                   "lists, quotes or emphasis are nested a hundred deep here",
                   "give it fewer levels; for such characters as text, write `\\>` or `\\*`");
  } else if (excess == Excess::cells) {
    reading_.error("E-table-size", span,
                   "a table has at most 200 columns, and all tables of a lesson 10000 cells",
                   "show a part of it, or a plot; each row has a cell in each column");
  } else {
    reading_.error("E-reference-size", span,
                   "this reference with all links that may name it is more than 64 MiB",
                   "end it with an empty line, and give it a shorter address");
  }
}

// Has the file more parts than are read? Says so once, at the first.
bool LessonReader::is_too_much(const SourceCursor& cursor) {
  if (++parts_ == kMostParts + 1) {
    reading_.error("E-lesson-size", cursor.text.span(cursor.at, cursor.at + 1),
                   "a lesson has at most 10000 paragraphs, formulas, links and other parts in all",
                   "make several of it");
  }
  return parts_ > kMostParts;
}

Document LessonReader::parse(const std::string& text, int first_line) {
  const auto refuse = [&](Excess excess, int line) {
    const std::size_t start = source().line_start(std::max(line, 1));
    refuse_excess(excess, {start, start + 1});
  };
  Losses losses;
  Document document = parse_markdown(text, refuse, first_line, &losses, lesson_.typography);
  if (!losses.empty())
    tell_losses(losses, located(source(), {0, source().text().size()}), reading_);
  return document;
}

Document LessonReader::fragment(const LocatedText& text) {
  if (text.text.empty()) return nullptr;
  Losses losses;
  const auto refuse = [&](Excess excess, int) { refuse_excess(excess, text.span()); };
  Document document = parse_markdown(text.text, refuse, 1, &losses, lesson_.typography);
  tell_losses(losses, text, reading_);
  const bool outer = std::exchange(in_document_, false);
  SourceCursor cursor{text, 0};
  walk(document.get(), cursor);
  in_document_ = outer;
  return document;
}

void LessonReader::walk(cmark_node* node, SourceCursor& cursor) {
  const cmark_node_type type = cmark_node_get_type(node);
  if (in_document_ && CMARK_NODE_TYPE_BLOCK_P(type) && cmark_node_get_start_line(node) > 0) {
    cursor.at = std::max(cursor.at, source().line_start(cmark_node_get_start_line(node)));
  }
  if (is_part(node) && is_too_much(cursor)) return;
  if (CMARK_NODE_TYPE_BLOCK_P(type)) {
    warn_of_mere_text(node, cursor.text, in_document_, lesson_, reading_);
  }
  if (type == CMARK_NODE_CODE_BLOCK) return read_code_block(node, cursor);
  if (type == math_inline_type() || type == math_block_type()) {
    return lesson_.add(node, read_math(node, cursor, math_, reading_));
  }
  if (type == CMARK_NODE_IMAGE) return read_image(node, cursor);
  if (type == CMARK_NODE_BLOCK_QUOTE) read_callout(node);
  if (type == CMARK_NODE_HEADING) read_heading(node, cursor);
  if (type == CMARK_NODE_FOOTNOTE_DEFINITION) return read_footnote(node, cursor);
  if (type == CMARK_NODE_CODE) read_code_span(node, cursor);
  const std::size_t behind = type == CMARK_NODE_LINK ? read_link(node, cursor) : 0;
  if (type == CMARK_NODE_FOOTNOTE_REFERENCE) refuse_footnote_in_link(node, cursor, reading_);
  if (type == CMARK_NODE_HTML_BLOCK || type == CMARK_NODE_HTML_INLINE) {
    read_html(node, cursor.find(cmark_node_get_literal(node)), html_, reading_);
  }
  if (type == CMARK_NODE_BLOCK_QUOTE) walk_title(node, cursor);
  walk_children(node, cursor);
  if (type == CMARK_NODE_HEADING) read_title(node);
  if (type == CMARK_NODE_BLOCK_QUOTE) read_end_of(node);
  cursor.at = std::max(cursor.at, behind);
}

// The title of a callout was moved out of the tree, and is walked with it.
void LessonReader::walk_title(cmark_node* callout, SourceCursor& cursor) {
  const Block* block = lesson_.block(callout);
  const auto* known = block != nullptr ? std::get_if<Callout>(block) : nullptr;
  if (known == nullptr || known->title == nullptr) return;
  in_callout_title_ = true;
  walk(known->title.get(), cursor);
  in_callout_title_ = false;
}

void LessonReader::walk_children(cmark_node* node, SourceCursor& cursor) {
  for (cmark_node* child = cmark_node_first_child(node);
       child != nullptr && parts_ <= kMostParts;) {
    if (cmark_node_get_type(child) == CMARK_NODE_TEXT) {
      child = read_text(child, cursor);  // which may cut it into several
      continue;
    }
    cmark_node* next = cmark_node_next(child);
    walk(child, cursor);
    child = next;
  }
  html_.open.end(node, reading_);
}

void LessonReader::read_code_span(cmark_node* node, SourceCursor& cursor) {
  const std::string code = cmark_node_get_literal(node);
  if (!is_value(code)) return cursor.pass_code(code);
  std::optional<InlineValue> value = read_value(cursor.find(code), reading_);
  if (value) lesson_.add(node, *std::move(value));
}

std::size_t LessonReader::read_link(cmark_node* node, const SourceCursor& cursor) {
  ReadLink read = mjcourse::read_link(node, cursor, reading_);
  lesson_.links.push_back(std::move(read.link));
  return read.behind;
}

void LessonReader::read_heading(cmark_node* node, const SourceCursor& cursor) {
  if (!in_document_) {
    reading_.error("E-heading-nested", cursor.text.span(),
                   "Markdown inside JSON cannot hold a heading", "use bold text: `**…**`");
    return;
  }
  lesson_.headings.push_back(mjcourse::read_heading(node, heading_ids_, reading_));
  lesson_.headings.back().in_demo = in_demo_;
}

// Its text, once what stands in it was read.
void LessonReader::read_title(cmark_node* heading) {
  if (!in_document_) return;
  lesson_.headings.back().title = title_of_heading(heading, lesson_);
}

void LessonReader::read_footnote(cmark_node* node, const SourceCursor& cursor) {
  SourceCursor own = begin_of_footnote(node, cursor.text, in_document_, source());
  if (in_document_) refuse_second_footnote(node, footnotes_, reading_);
  walk_children(node, own);
}

void LessonReader::read_callout(cmark_node* node) {
  if (!in_document_) return;
  if (std::optional<Callout> callout = take_callout(node, reading_))
    lesson_.add(node, std::move(*callout));
}

void LessonReader::read_image(cmark_node* node, SourceCursor& cursor) {
  // The text of the picture, which may hold the file's name as well, stands before it.
  const std::size_t target = cursor.text.text.find("](", cursor.at);
  if (target != std::string::npos) cursor.at = target + 2;
  const LocatedText file = file_of_target(cursor.find(cmark_node_get_url(node)));
  const bool alone = stands_alone(node);
  std::optional<Image> image = mjcourse::read_image(node, file, alone, reading_);
  if (image) lesson_.add(alone ? cmark_node_parent(node) : node, *std::move(image));
}

// Is the picture a whole paragraph of the lesson's own text?
bool LessonReader::stands_alone(cmark_node* node) const {
  cmark_node* paragraph = cmark_node_parent(node);
  if (!in_document_ || cmark_node_get_type(paragraph) != CMARK_NODE_PARAGRAPH) return false;
  if (cmark_node_next(node) != nullptr || cmark_node_previous(node) != nullptr) return false;
  return !in_callout_title_;
}

// Where a callout's claim is from and where it ends, once what stands in it was read.
void LessonReader::read_end_of(cmark_node* quote) {
  const auto found = lesson_.block_of.find(quote);
  if (found == lesson_.block_of.end()) return;
  if (auto* callout = std::get_if<Callout>(&lesson_.blocks[found->second])) {
    callout->source = source_in(quote);
    callout->end = lesson_.blocks.size();
  }
}

// Gives the node to go on with.
cmark_node* LessonReader::read_text(cmark_node* node, SourceCursor& cursor) {
  refuse_unclosed_math(node, cursor, in_document_, math_, reading_);
  refuse_blank_in_name(node, cursor.text, cursor.at, reading_);
  TextWithTerms text(node);
  std::size_t at = 0;
  while (const std::optional<CutTerm> term = next_term(node, text, at, cursor, reading_)) {
    if (is_too_much(cursor)) continue;
    ReadTerm read = read_term(*term, in_callout_title_, cursor, reading_);
    if (read.use) lesson_.add(term->node, *std::move(read.use));
    walk_children(term->node, cursor);
    cursor.at = std::max(cursor.at, read.behind);
  }
  return text.finish();
}

void LessonReader::read_code_block(cmark_node* node, SourceCursor& cursor) {
  if (!in_document_) {
    reading_.error("E-fence-nested", cursor.text.span(),
                   "Markdown inside JSON cannot hold a code block", "use a code span: `…`");
    return;
  }
  Fence fence(node, source());
  if (refuse_unclosed(fence, reading_)) return;
  if (fence.kind() == "demo") return read_demo(node, fence, cursor);
  if (fence.kind() == "text" && !is_unchecked(fence)) {
    return read_output(node, fence, lesson_, reading_);
  }
  if (auto block = read_fence(fence, *this)) lesson_.add(node, *std::move(block));
}

// cmark's line numbers are the lesson's own, so the walk places what it finds as it does everywhere
// else.
void LessonReader::read_demo(cmark_node* node, const Fence& fence, SourceCursor& cursor) {
  if (!check_demo(fence, in_demo_, reading_)) return;
  const std::string& text = fence.body().text;
  Document document = parse(text, source().position(fence.span().begin).line + 1);
  in_demo_ = true;
  walk(document.get(), cursor);
  in_demo_ = false;
  lesson_.add(node, Demo{text, std::move(document)});
}

}  // namespace mjcourse
