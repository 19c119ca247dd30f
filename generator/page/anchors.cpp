#include "page/anchors.h"

#include <algorithm>
#include <cctype>

namespace mjcourse {
namespace {

// The number of the lesson's blocks of this kind up to blocks[index]: "lab-2" is the second.
template <typename Kind>
std::string numbered(const std::string& name, const Lesson& lesson, std::size_t index) {
  const auto end = lesson.blocks.begin() + static_cast<std::ptrdiff_t>(index) + 1;
  const auto number = std::count_if(lesson.blocks.begin(), end, [](const Block& block) {
    return std::holds_alternative<Kind>(block);
  });
  return name + "-" + std::to_string(number);
}

std::string heading_above(const Lesson& lesson, int line) {
  std::string id;
  for (const Heading& heading : lesson.headings) {
    if (cmark_node_get_start_line(heading.node) <= line) id = heading.id;
  }
  return id;
}

}  // namespace

std::string as_id(std::string text) {
  for (char& c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
  }
  return text;
}

std::string lesson_anchor(const Lesson& lesson) {
  return "lesson-" + as_id(lesson.number.empty() ? lesson.slug : lesson.number);
}

std::string claim_anchor(const Lesson& lesson, std::size_t index) {
  return lesson_anchor(lesson) + "-" + std::to_string(index + 1);
}

std::string example_anchor(const Example& example) {
  return "example-" + example.name() + (example.region ? "-" + example.region->text : "");
}

std::string question_anchor(const Quiz& quiz, std::size_t question) {
  return "quiz-" + as_id(quiz.id) + "-" + std::to_string(question + 1);
}

std::string place_anchor(const Lesson& lesson, const Claim& claim) {
  const Block* block = &lesson.blocks[claim.block];
  if (const auto* output = std::get_if<Output>(block)) block = &lesson.blocks[output->example];
  if (const auto* example = std::get_if<Example>(block)) return example_anchor(*example);
  if (const auto* quiz = std::get_if<Quiz>(block)) return question_anchor(*quiz, claim.part);
  const std::size_t index = claim.block;
  if (std::holds_alternative<Lab>(*block)) return numbered<Lab>("lab", lesson, index);
  if (std::holds_alternative<Figure>(*block)) return numbered<Figure>("figure", lesson, index);
  if (std::holds_alternative<Chart>(*block)) return numbered<Chart>("plot", lesson, index);
  return heading_above(lesson, claim.place.line);
}

}  // namespace mjcourse
