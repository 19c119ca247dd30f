#include "findings/model_page.h"

namespace mjcourse {

std::string alt_of(const ModelPage& page) {
  return "The model " + page.name + " in its initial state";
}

}  // namespace mjcourse
