#include "page/without_solutions.h"

#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include "course/uses.h"

namespace mjcourse {
namespace {

const Example* shown_program(const Lesson& lesson, std::size_t index) {
  const Block& block = lesson.blocks[index];
  if (const auto* output = std::get_if<Output>(&block)) {
    return std::get_if<Example>(&lesson.blocks[output->example]);
  }
  return std::get_if<Example>(&block);
}

std::set<std::size_t> solutions_in(const Lesson& lesson, const std::set<std::string>& programs) {
  std::set<std::size_t> found;
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    const auto* callout = std::get_if<Callout>(&lesson.blocks[i]);
    if (callout != nullptr && callout->kind == "solution") {
      for (std::size_t inside = i; inside < callout->end; ++inside) found.insert(inside);
    }
    const Example* program = shown_program(lesson, i);
    if (program != nullptr && programs.contains(program->file.text)) found.insert(i);
  }
  return found;
}

void withhold(Lesson& lesson, const std::set<std::size_t>& blocks) {
  for (const std::size_t block : blocks) {
    lesson.withheld.push_back(std::exchange(lesson.blocks[block], Shown{}));
  }
}

}  // namespace

std::set<std::string> exercise_programs(const Course& course) {
  std::set<std::string> programs;
  for (const Lesson& lesson : course.lessons) {
    for (const Block& block : lesson.blocks) {
      const auto* exercise = std::get_if<Exercise>(&block);
      if (exercise != nullptr) programs.insert(exercise->program.file.text);
    }
  }
  return programs;
}

void withhold_solutions(Lesson& lesson, const std::set<std::string>& programs) {
  withhold(lesson, solutions_in(lesson, programs));
}

void withhold_solutions(Course& course, Evaluation& evaluation) {
  const std::set<std::string> programs = exercise_programs(course);
  std::vector<std::set<std::size_t>> withheld;
  for (std::size_t i = 0; i < course.lessons.size(); ++i) {
    Lesson& lesson = course.lessons[i];
    LessonResults& results = evaluation.lessons[i];
    const std::set<std::size_t>& blocks = withheld.emplace_back(solutions_in(lesson, programs));
    for (const std::size_t block : blocks) results.of_block.erase(block);
    std::erase_if(results.claims, [&](const Claim& claim) {
      return blocks.contains(claim.block) && claim.kind != Claim::Kind::citation;
    });
    results.tally = tally_of(results.claims);
    withhold(lesson, blocks);
  }
  // Nor is it told which of MuJoCo's names a solution uses.
  std::erase_if(evaluation.api, [&](ApiEntry& entry) {
    const std::size_t erased = std::erase_if(entry.uses_in_code, [&](const CodeUse& use) {
      return use.page < withheld.size() && withheld[use.page].contains(use.block);
    });
    return erased > 0 && entry.uses_in_code.empty() &&
           uses_of_link(course, "api:" + entry.name).empty();
  });
}

}  // namespace mjcourse
