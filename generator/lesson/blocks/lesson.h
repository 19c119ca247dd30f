// Lesson: a Markdown file, understood.
//
// Enter at read_lesson (lesson/read_lesson.h). What always holds: every block stands in document
// order, and every block and link knows its place in the source. A lesson that was read with errors
// is still a lesson: what could not be understood is left out. So later stages find their mistakes
// in the same run.
// Tested by tests/generator/lesson/read_lesson_test.cpp.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "base/source_text.h"
#include "lesson/blocks/block.h"
#include "lesson/syntax/markdown.h"
#include "lesson/syntax/typography.h"

namespace mjcourse {

struct FrontMatter {
  LocatedText title;
  Document summary;  // null when there is none
  std::optional<int> minutes;
  std::vector<LocatedText> prerequisites;  // lesson numbers
  std::vector<Document> objectives;
  std::vector<std::string> tags;
  bool draft = false;                 // checked like any other, and left out of the site
  std::vector<LocatedText> formerly;  // the addresses that its page had (course/former_page.h)
};

// A stretch of a heading's text; what an inline value comes to, and how a formula looks, is known
// only later.
struct TitlePart {
  std::string text;                  // without markup
  std::optional<std::size_t> block;  // of an InlineValue or a Math
};

struct Heading {
  int level = 2;
  std::string id;        // unique in its lesson: the fragment of links to it
  cmark_node* node;      // in the lesson's document; null once unloaded
  bool in_demo = false;  // then the page's contents leave it out
  int line = 0;          // where it begins
  std::vector<TitlePart> title{};
};

struct Link {
  cmark_node* node;                // null once unloaded
  LocatedText target;              // as written: "1.3#anchor", "https://…"
  bool in_angle_brackets = false;  // `<https://…>`, and `<std::string>`, which was meant as text
};

struct Lesson {
  std::shared_ptr<const SourceText> source;
  std::string folder;  // of its level: "1-state"
  std::string slug;    // "1.2-generalized-coordinates"
  std::string number;  // "1.2"; "" for the glossary, which is read like a lesson
  Typography typography;
  FrontMatter front;
  Document document;
  std::vector<Block> blocks;                                    // in document order
  std::unordered_map<const cmark_node*, std::size_t> block_of;  // nodes that a block stands for
  std::vector<Block> withheld{};  // no longer shown; their nodes are still known to block_of
  std::vector<Heading> headings;
  std::vector<Link> links;
  bool sound = true;                      // reading it found no mistake
  std::optional<std::size_t> index = {};  // in Course::lessons; nothing of a page beside them

  // How much of it is there (lesson/unloaded_lesson.h): all of it; all but its trees, which are
  // `document`, `block_of`, the nodes, and those of the front matter; or an outline. That is where
  // the lesson is, its title, its headings, and these three.
  enum class Kept { all, blocks, outline } kept = Kept::all;
  std::string hash;        // of an outline: the lesson's bytes'
  std::size_t length = 0;  // of an outline: how many these are
  int unchecked = 0;       // of an outline: how many such blocks the lesson has

  // A block that `node` stands for.
  void add(const cmark_node* node, Block block) {
    block_of[node] = blocks.size();
    blocks.push_back(std::move(block));
  }

  // The block that `node` stands for; null for plain Markdown.
  const Block* block(const cmark_node* node) const {
    const auto found = block_of.find(node);
    return found == block_of.end() ? nullptr : &blocks[found->second];
  }
};

// The indices of its blocks of one kind.
template <typename Kind>
std::vector<std::size_t> blocks_of(const Lesson& lesson) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    if (std::holds_alternative<Kind>(lesson.blocks[i])) found.push_back(i);
  }
  return found;
}

// Which of its kind in the lesson the block `index` is, from 1.
int block_number(const Lesson& lesson, std::size_t index);

// What its page and its files call a lab, a figure or a plot: "lab-2"; "" for any other block.
std::string block_name(const Lesson& lesson, std::size_t index);

}  // namespace mjcourse
