#include "lesson/json/vocabulary.h"

#include <algorithm>

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

}  // namespace mjcourse
