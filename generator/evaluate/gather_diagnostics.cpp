#include "evaluate/gather_diagnostics.h"

#include <algorithm>
#include <utility>

namespace mjcourse {
namespace {

bool is_of_a_shared_file(const Diagnostic& one) {
  return one.id == "E-model-mjcf" || one.id == "E-example-compile" || one.id == "W-example-compile";
}

bool same_mistake(const Diagnostic& a, const Diagnostic& b) {
  return is_of_a_shared_file(a) && a.id == b.id && a.message == b.message &&
         a.place.file == b.place.file && a.place.line == b.place.line &&
         a.place.column == b.place.column && !a.notes.empty();
}

}  // namespace

void gather_diagnostics(Diagnostics found, Diagnostics& all) {
  for (Diagnostic& one : found) {
    const auto known = std::find_if(
        all.begin(), all.end(), [&](const Diagnostic& other) { return same_mistake(one, other); });
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
