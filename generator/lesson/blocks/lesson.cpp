#include "lesson/blocks/lesson.h"

#include <algorithm>

namespace mjcourse {

int block_number(const Lesson& lesson, std::size_t index) {
  const auto end = lesson.blocks.begin() + static_cast<std::ptrdiff_t>(index) + 1;
  const std::size_t kind = lesson.blocks[index].index();
  return static_cast<int>(std::count_if(lesson.blocks.begin(), end,
                                        [&](const Block& block) { return block.index() == kind; }));
}

std::string block_name(const Lesson& lesson, std::size_t index) {
  const Block& block = lesson.blocks[index];
  const char* kind = std::holds_alternative<Lab>(block)      ? "lab"
                     : std::holds_alternative<Figure>(block) ? "figure"
                     : std::holds_alternative<Plot>(block)   ? "plot"
                                                             : nullptr;
  return kind == nullptr ? ""
                         : std::string(kind) + "-" + std::to_string(block_number(lesson, index));
}

}  // namespace mjcourse
