// LessonReader: the walk over a lesson's Markdown tree that finds the blocks.
//
// What it finds is read by functions (read_math.h and its kin). Those of blocks that hold Markdown
// inside JSON (read_lab.h) get this reader, which reads that.
// Tested by tests/generator/lesson/read_lesson_test.cpp.
// Tested by tests/generator/lesson/bounds_test.cpp.
#pragma once

#include <string>

#include "lesson/blocks/lesson.h"
#include "lesson/blocks/read_footnote.h"
#include "lesson/blocks/read_heading.h"
#include "lesson/blocks/read_html.h"
#include "lesson/blocks/read_math.h"
#include "lesson/syntax/reading.h"
#include "lesson/syntax/source_cursor.h"

namespace mjcourse {

class LessonReader {
 public:
  LessonReader(Lesson& lesson, Reading& reading) : lesson_(lesson), reading_(reading) {}

  // Read the lesson's document, which stands in its source line for line.
  void read_document();

  // The lesson's Markdown, or a part of it, which begins in a line of the source.
  Document parse(const std::string& text, int first_line);

  // Markdown that stands somewhere inside a block: its formulas and links join the lesson's.
  Document fragment(const LocatedText& text);

  Reading& reading() { return reading_; }
  // As far as it was read.
  const Lesson& lesson() const { return lesson_; }
  const SourceText& source() const { return reading_.source(); }

 private:
  void walk(cmark_node* node, SourceCursor& cursor);
  void walk_children(cmark_node* node, SourceCursor& cursor);
  void walk_title(cmark_node* callout, SourceCursor& cursor);
  void refuse_excess(Excess excess, Span span);
  bool is_too_much(const SourceCursor& cursor);
  void read_code_block(cmark_node* node, SourceCursor& cursor);
  void read_demo(cmark_node* node, const class Fence& fence, SourceCursor& cursor);
  void read_callout(cmark_node* node);
  void read_end_of(cmark_node* quote);
  void read_heading(cmark_node* node, const SourceCursor& cursor);
  void read_title(cmark_node* heading);
  void read_footnote(cmark_node* node, const SourceCursor& cursor);
  void read_code_span(cmark_node* node, SourceCursor& cursor);
  std::size_t read_link(cmark_node* node, const SourceCursor& cursor);
  cmark_node* read_text(cmark_node* node, SourceCursor& cursor);
  void read_image(cmark_node* node, SourceCursor& cursor);
  bool stands_alone(cmark_node* node) const;

  Lesson& lesson_;
  Reading& reading_;
  bool in_document_ = false;
  bool in_demo_ = false;
  bool in_callout_title_ = false;
  int parts_ = 0;  // that were walked
  MathState math_;
  HtmlState html_;
  HeadingIds heading_ids_;
  FootnoteNames footnotes_;
};

}  // namespace mjcourse
