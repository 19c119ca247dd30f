#include "page/reader_text.h"

#include <sstream>

namespace mjcourse {
namespace {

std::string text_of(cmark_node* node, const Lesson& page, const LessonResults& results) {
  if (const auto block = page.block_of.find(node); block != page.block_of.end()) {
    const auto* value = results.get<ValueResult>(block->second);
    if (value != nullptr) return value->text;
  }
  cmark_node* child = cmark_node_first_child(node);
  if (child == nullptr) return plain_text(node);
  std::string text;
  for (; child != nullptr; child = cmark_node_next(child)) text += text_of(child, page, results);
  return cmark_node_get_type(node) == CMARK_NODE_PARAGRAPH ? text + " " : text;
}

std::string with_single_blanks(const std::string& spaced) {
  std::istringstream words(spaced);
  std::string text;
  for (std::string word; words >> word;) text += (text.empty() ? "" : " ") + word;
  return text;
}

}  // namespace

std::string reader_text(cmark_node* node, const Lesson& page, const LessonResults& results) {
  return with_single_blanks(text_of(node, page, results));
}

std::string reader_text(const Heading& heading, const LessonResults& results) {
  std::string text;
  for (const TitlePart& part : heading.title) {
    const auto* value = part.value ? results.get<ValueResult>(*part.value) : nullptr;
    text += value != nullptr ? value->text : part.text;
  }
  return with_single_blanks(text);
}

}  // namespace mjcourse
