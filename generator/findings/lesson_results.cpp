#include "findings/lesson_results.h"

namespace mjcourse {

std::vector<const PinComparison*> pins_of(const LessonResults& results) {
  std::vector<const PinComparison*> pins;
  for (const auto& [index, result] : results.of_block) {
    const auto* figure = std::get_if<FigureResult>(&result);
    const auto* lab = std::get_if<LabResult>(&result);
    if (figure != nullptr && figure->pin) pins.push_back(&*figure->pin);
    if (lab != nullptr && lab->pin) pins.push_back(&*lab->pin);
  }
  return pins;
}

}  // namespace mjcourse
