#include "evaluate/context/shown_program.h"

#include <algorithm>

namespace mjcourse {

const Example* ShownProgram::text() const {
  const auto found = std::find_if(whole.begin(), whole.end(), [](const Example* example) {
    return !example->code.text.empty();
  });
  return found == whole.end() ? nullptr : *found;
}

bool ShownProgram::contradicts_itself() const {
  std::map<std::string, const std::string*> said;  // by region; "" is the whole
  const auto contradicts = [&](const Example* example) {
    const std::string& code = example->code.text;
    if (code.empty()) return false;
    const std::string name = example->region ? example->region->text : "";
    return *said.emplace(name, &code).first->second != code;
  };
  return std::any_of(whole.begin(), whole.end(), contradicts) ||
         std::any_of(regions.begin(), regions.end(), contradicts);
}

ShownPrograms shown_programs(const Course& course) {
  ShownPrograms programs;
  for (const Lesson& lesson : course.lessons) {
    for (const Block& block : lesson.blocks) {
      const auto* exercise = std::get_if<Exercise>(&block);
      if (exercise != nullptr) programs[exercise->program.file.text].exercises.push_back(exercise);
      const auto* example = std::get_if<Example>(&block);
      if (example == nullptr) continue;
      ShownProgram& program = programs[example->file.text];
      (example->region ? program.regions : program.whole).push_back(example);
    }
  }
  return programs;
}

}  // namespace mjcourse
