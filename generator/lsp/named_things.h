// NamedThings: what a lesson names of what stands elsewhere, each with the place of the name:
// models, programs, terms, where links lead.
#pragma once

#include <string>
#include <vector>

#include "lesson/blocks/lesson.h"

namespace mjcourse {

struct NamedThing {
  enum class Kind { model, program, file, term, link };
  Kind kind;
  LocatedText name;  // as it is written
  std::string what;  // of a term, its key; of a file, the region
};

std::vector<NamedThing> named_things(const Lesson& lesson);

}  // namespace mjcourse
