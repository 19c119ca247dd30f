#include "lesson/json/json_fences.h"

#include <array>

#include "lesson/json/figure_vocabulary.h"
#include "lesson/json/lab_vocabulary.h"
#include "lesson/json/plot_vocabulary.h"
#include "lesson/json/quiz_vocabulary.h"

namespace mjcourse {

std::span<const JsonFence> json_fences() {
  static constexpr std::array all{
      JsonFence{"lab", "lab simlab", &words::kLab}, JsonFence{"quiz", "quiz", &words::kQuiz},
      JsonFence{"figure", "figure", &words::kFigure}, JsonFence{"plot", "plot", &words::kPlot}};
  return all;
}

const Vocabulary* vocabulary_of(std::string_view fence) {
  for (const JsonFence& one : json_fences()) {
    if (one.name == fence) return one.vocabulary;
  }
  return nullptr;
}

}  // namespace mjcourse
