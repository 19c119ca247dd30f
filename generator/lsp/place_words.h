// What the vocabulary has for a place in a fence's JSON (lesson/json/vocabulary.h).
#pragma once

#include <string_view>

#include "lesson/json/vocabulary.h"
#include "lsp/json_place.h"

namespace mjcourse {

struct PlaceWords {
  const Vocabulary* object = nullptr;  // of the object around; null where none is known
  const Key* key = nullptr;            // behind which the place is
};

// Of a fence of this kind: "lab". Where a word decides what an object is, and it is not written
// yet, the object has that word alone.
PlaceWords words_at(std::string_view fence, const JsonPlace& place);

}  // namespace mjcourse
