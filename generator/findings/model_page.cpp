#include "findings/model_page.h"

#include "lesson/lesson_of_lab.h"

namespace mjcourse {

std::string alt_of(const ModelPage& page) {
  return "The model " + page.name + " in its initial state";
}

Lesson lesson_of_lab(const ModelPage& page) {
  Diagnostics none;
  return lesson_of_lab(page.name, page.lab->fence, none);
}

}  // namespace mjcourse
