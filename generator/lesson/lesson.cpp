#include "lesson/lesson.h"

#include <algorithm>

namespace mjcourse {

int chart_number(const Lesson& lesson, std::size_t index) {
  const auto end = lesson.blocks.begin() + static_cast<std::ptrdiff_t>(index) + 1;
  return static_cast<int>(std::count_if(lesson.blocks.begin(), end, [](const Block& block) {
    return std::holds_alternative<Chart>(block);
  }));
}

}  // namespace mjcourse
