#include "evaluate/gather_diagnostics.h"

#include <algorithm>
#include <utility>

namespace mjcourse {
namespace {

bool same_model_mistake(const Diagnostic& a, const Diagnostic& b) {
  return a.id == "E-model-mjcf" && a.id == b.id && a.message == b.message &&
         a.place.file == b.place.file && a.place.line == b.place.line && !a.notes.empty();
}

}  // namespace

void gather_diagnostics(Diagnostics found, Diagnostics& all) {
  for (Diagnostic& one : found) {
    const auto known = std::find_if(all.begin(), all.end(), [&](const Diagnostic& other) {
      return same_model_mistake(one, other);
    });
    if (known == all.end()) {
      all.push_back(std::move(one));
      continue;
    }
    for (Note& note : one.notes) {
      const bool noted =
          std::any_of(known->notes.begin(), known->notes.end(),
                      [&](const Note& other) { return other.place.file == note.place.file; });
      if (!noted) known->notes.push_back(std::move(note));
    }
  }
}

}  // namespace mjcourse
