#include "lesson/blocks/read_heading.h"

#include <variant>

#include "lesson/syntax/heading_id.h"

namespace mjcourse {
namespace {

void add_title_parts(cmark_node* node, const Lesson& lesson, std::vector<TitlePart>& title) {
  const auto block = lesson.block_of.find(node);
  if (block != lesson.block_of.end() &&
      (std::holds_alternative<InlineValue>(lesson.blocks[block->second]) ||
       std::holds_alternative<Math>(lesson.blocks[block->second]))) {
    title.push_back({plain_text(node), block->second});
    return;
  }
  cmark_node* child = cmark_node_first_child(node);
  if (child == nullptr) title.push_back({plain_text(node), std::nullopt});
  for (; child != nullptr; child = cmark_node_next(child)) add_title_parts(child, lesson, title);
}

}  // namespace

Heading read_heading(cmark_node* node, HeadingIds& ids, Reading& reading) {
  const int level = cmark_node_get_heading_level(node), line = cmark_node_get_start_line(node);
  if (level == 1) {
    const std::size_t start = reading.source().line_start(line);
    reading.error("E-heading-level", {start, start + 1},
                  "a lesson's own headings begin at the second level (`##`)",
                  "the page's first heading is the `title` of the front matter");
  }
  const std::string slug = id_of_heading(plain_text(node));
  std::string id = slug;
  while (!ids.used.insert(id).second) {
    int& number = ids.numbers.try_emplace(slug, 1).first->second;
    id = slug + "-" + std::to_string(++number);
  }
  return {level, id, node, false, line};
}

std::vector<TitlePart> title_of_heading(cmark_node* node, const Lesson& lesson) {
  std::vector<TitlePart> title;
  add_title_parts(node, lesson, title);
  return title;
}

}  // namespace mjcourse
