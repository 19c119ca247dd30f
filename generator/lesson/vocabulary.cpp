#include "lesson/vocabulary.h"

#include <algorithm>
#include <array>

#include "lesson/chart_vocabulary.h"
#include "lesson/figure_vocabulary.h"
#include "lesson/lab_vocabulary.h"
#include "lesson/quiz_vocabulary.h"

namespace mjcourse {

const Key* Vocabulary::find(std::string_view key) const {
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const Key& one) { return one.name == key; });
  return found == keys.end() ? nullptr : &*found;
}

const Vocabulary* Vocabulary::variant(std::string_view word) const {
  const auto found = std::find_if(variants.begin(), variants.end(),
                                  [&](const Variant& one) { return one.word == word; });
  return found == variants.end() ? nullptr : found->vocabulary;
}

std::span<const JsonFence> json_fences() {
  static constexpr std::array all{
      JsonFence{"lab", "lab simlab", &words::kLab}, JsonFence{"quiz", "quiz", &words::kQuiz},
      JsonFence{"figure", "figure", &words::kFigure}, JsonFence{"plot", "plot", &words::kChart}};
  return all;
}

const Vocabulary* vocabulary_of(std::string_view fence) {
  for (const JsonFence& one : json_fences()) {
    if (one.name == fence) return one.vocabulary;
  }
  return nullptr;
}

}  // namespace mjcourse
