#include "page/html/reader_text.h"

#include <optional>
#include <utility>

#include "base/running_text.h"
#include "page/html/formula_text.h"

namespace mjcourse {
namespace {

// What the build made of a value or a formula; nothing of other blocks.
std::optional<std::string> shown_text(const LessonResults& results, std::size_t block) {
  if (const auto* value = results.get<ValueResult>(block)) return value->text;
  const auto* formula = results.get<FormulaResult>(block);
  if (formula == nullptr) return std::nullopt;
  std::string text = formula_text(formula->markup);
  return text.empty() ? std::nullopt : std::optional(std::move(text));
}

std::string text_of(cmark_node* node, const Lesson& page, const LessonResults& results) {
  if (const auto block = page.block_of.find(node); block != page.block_of.end()) {
    if (const auto shown = shown_text(results, block->second)) return *shown;
  }
  cmark_node* child = cmark_node_first_child(node);
  if (child == nullptr) return plain_text(node);
  std::string text;
  for (; child != nullptr; child = cmark_node_next(child)) text += text_of(child, page, results);
  return cmark_node_get_type(node) == CMARK_NODE_PARAGRAPH ? text + " " : text;
}

}  // namespace

std::string reader_text(cmark_node* node, const Lesson& page, const LessonResults& results) {
  return with_single_blanks(text_of(node, page, results));
}

std::string reader_text(const Heading& heading, const LessonResults& results) {
  std::string text;
  for (const TitlePart& part : heading.title) {
    text += (part.block ? shown_text(results, *part.block) : std::nullopt).value_or(part.text);
  }
  return with_single_blanks(text);
}

std::string text_of_formula(const FormulaResult* result, const std::string& tex) {
  const std::string text = result != nullptr ? formula_text(result->markup) : "";
  return text.empty() ? tex : text;
}

}  // namespace mjcourse
