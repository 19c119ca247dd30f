// LessonReader: the walk over a lesson's Markdown tree that finds the blocks.
//
// The readers of single blocks (read_lab.h and its kin) get this reader: it takes their mistakes,
// and reads the Markdown that stands inside their JSON.
// Tested by tests/generator/lesson/read_lesson_test.cpp.
// Tested by tests/generator/lesson/bounds_test.cpp.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lesson/blocks/lesson.h"
#include "lesson/blocks/read_html.h"
#include "lesson/syntax/reading.h"

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
  const SourceText& source() const { return reading_.source(); }

 private:
  // Where in the author's text the walk is, to find the place of what cmark does not place.
  struct Region {
    const LocatedText& text;
    std::size_t cursor = 0;
  };

  void walk(cmark_node* node, Region& region);
  void walk_children(cmark_node* node, Region& region);
  void add(cmark_node* node, Block block);
  void refuse_excess(Excess excess, Span span);
  bool is_too_much(const Region& region);
  void read_code_block(cmark_node* node, Region& region);
  void read_callout(cmark_node* node);
  void read_source_of(cmark_node* quote);
  void read_heading(cmark_node* node, const Region& region);
  void read_title(cmark_node* heading);
  void add_title_parts(cmark_node* node, std::vector<TitlePart>& title) const;
  void read_footnote(cmark_node* node, const Region& region);
  void refuse_second_footnote(cmark_node* node);
  void read_math(cmark_node* node, Region& region);
  void warn_of_doubtful_math(const LocatedText& tex);
  void read_code_span(cmark_node* node, Region& region);
  static void pass_code_span(const std::string& code, Region& region);
  std::size_t read_link(cmark_node* node, const Region& region);
  std::size_t read_autolink(cmark_node* node, Region words);
  void refuse_link_in_heading(cmark_node* node);
  void refuse_footnote_in_link(cmark_node* node, const Region& region);
  cmark_node* read_text(cmark_node* node, Region& region);
  void read_term(const struct CutTerm& term, Region& region);
  static bool pass_brackets(Region& region);
  void refuse_unclosed_math(cmark_node* node, const Region& region);
  void refuse_empty_link(cmark_node* node, Span target);
  void read_image(cmark_node* node, Region& region);
  bool stands_alone(cmark_node* node) const;
  void read_fence(cmark_node* node, Region& region);
  void read_demo(cmark_node* node, class Fence& fence, Region& region);
  void read_output(cmark_node* node, class Fence& fence);
  void refuse_second_quiz(const Quiz& quiz, Span span);
  void refuse_second_pin(LocatedText& pin);
  std::optional<std::size_t> example_named(const LocatedText& name);
  LocatedText find(const std::string& text, Region& region);

  Lesson& lesson_;
  Reading& reading_;
  bool in_document_ = false;
  bool in_demo_ = false;
  bool in_callout_title_ = false;
  bool math_is_cut_ = false;  // a `$$` below text was not closed
  HtmlState html_;
  int parts_ = 0;  // that were walked
  std::set<std::string> heading_ids_;
  std::map<std::string, int> heading_numbers_;  // the last behind each slug that stands twice
  std::set<std::string> footnotes_;             // by their names
};

}  // namespace mjcourse
