#include "lsp/place_words.h"

#include <string>

#include "lesson/json/json_fences.h"

namespace mjcourse {
namespace {

const Vocabulary* decided(const Vocabulary* vocabulary, const JsonPlace::Object& object) {
  if (vocabulary->variants.empty()) return vocabulary;
  const auto word = object.texts.find(std::string(vocabulary->keys.front().name));
  if (word == object.texts.end()) return vocabulary;
  const Vocabulary* variant = vocabulary->variant(word->second);
  return variant != nullptr ? variant : vocabulary;
}

}  // namespace

PlaceWords words_at(std::string_view fence, const JsonPlace& place) {
  PlaceWords words;
  const Vocabulary* next = vocabulary_of(fence);
  for (const JsonPlace::Object& object : place.objects) {
    words = {};
    if (next == nullptr) return words;
    words.object = decided(next, object);
    words.key = words.object->find(object.key);
    // The word that decides has its choices in the undecided vocabulary.
    if (words.key != nullptr && words.key->kind == KeyKind::word) words.object = next;
    next = words.key != nullptr ? words.key->of : nullptr;
  }
  return words;
}

}  // namespace mjcourse
