// LessonReader: the walk over a lesson's Markdown tree that finds the blocks.
//
// The readers of single blocks (read_lab.h and its kin) get this reader: it takes their mistakes,
// and reads the Markdown that stands inside their JSON.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>

#include "lesson/lesson.h"
#include "lesson/reading.h"

namespace mjcourse {

class LessonReader {
 public:
  LessonReader(Lesson& lesson, Reading& reading) : lesson_(lesson), reading_(reading) {}

  // Read the lesson's document, which stands in its source line for line.
  void read_document();

  // Markdown that stands somewhere inside a block: its formulas and links join the lesson's.
  Document fragment(const LocatedText& text);

  Reading& reading() { return reading_; }
  const SourceText& source() const { return reading_.source(); }

 private:
  // Where in the author's text the walk is, to find the place of what cmark does not place.
  struct Region {
    LocatedText text;
    std::size_t cursor = 0;
  };

  void walk(cmark_node* node, Region& region);
  void add(cmark_node* node, Block block);
  void read_code_block(cmark_node* node, Region& region);
  void read_callout(cmark_node* node);
  void read_heading(cmark_node* node, const Region& region);
  void read_math(cmark_node* node, Region& region);
  void read_code_span(cmark_node* node, Region& region);
  void read_link(cmark_node* node, Region& region);
  void refuse_inline(cmark_node* node, Region& region);
  void read_fence(cmark_node* node);
  void read_output(cmark_node* node, class Fence& fence);
  void refuse_second_quiz(const Quiz& quiz, Span span);
  void refuse_second_pin(LocatedText& pin);
  std::optional<std::size_t> example_named(const LocatedText& name);
  LocatedText find(const std::string& text, Region& region);

  Lesson& lesson_;
  Reading& reading_;
  bool in_document_ = false;
  std::set<std::string> heading_ids_;
};

}  // namespace mjcourse
