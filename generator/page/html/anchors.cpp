#include "page/html/anchors.h"

#include <string_view>

#include "base/utf8.h"

namespace mjcourse {
namespace {

std::string heading_above(const Lesson& lesson, int line) {
  std::string id;
  for (const Heading& heading : lesson.headings) {
    if (heading.line <= line) id = heading.id;
  }
  return id;
}

}  // namespace

std::string as_id(std::string text) {
  for (char& c : text) {
    if (!is_letter_or_digit(c)) c = '-';
  }
  return text;
}

std::string id_of_name(std::string name) {
  constexpr std::string_view broken = "\"#%&'<>?\\`";
  for (char& c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= ' ' || byte == 0x7F || broken.find(c) != broken.npos) c = '-';
  }
  return name;
}

std::string lesson_anchor(const Lesson& lesson) {
  return "lesson-" + as_id(lesson.number.empty() ? lesson.slug : lesson.number);
}

std::string claim_anchor(const Lesson& lesson, std::size_t index) {
  return lesson_anchor(lesson) + "-" + std::to_string(index + 1);
}

std::string example_anchor(const Example& example) {
  return "example-" +
         id_of_name(example.name() + (example.region ? "-" + example.region->text : ""));
}

std::string exercise_anchor(const Exercise& exercise) {
  return "exercise-" + id_of_name(exercise.program.name());
}

std::string question_anchor(const Quiz& quiz, std::size_t question) {
  return "quiz-" + as_id(quiz.id) + "-" + std::to_string(question + 1);
}

std::string place_anchor(const Lesson& lesson, const Claim& claim) {
  const Block* block = &lesson.blocks[claim.block];
  if (const auto* output = std::get_if<Output>(block)) block = &lesson.blocks[output->example];
  if (const auto* example = std::get_if<Example>(block)) return example_anchor(*example);
  if (const auto* exercise = std::get_if<Exercise>(block)) return exercise_anchor(*exercise);
  if (const auto* quiz = std::get_if<Quiz>(block)) return question_anchor(*quiz, claim.part);
  const std::string name = block_name(lesson, claim.block);
  return name.empty() ? heading_above(lesson, claim.place.line) : name;
}

}  // namespace mjcourse
