#include "evaluate/scenes/step_count.h"

#include <cmath>
#include <sstream>

namespace mjcourse {

tl::expected<int, std::string> step_count(const Model& model, double seconds) {
  const double step = model->opt.timestep;
  const double steps = seconds / step;
  if (step > 0 && steps <= kMostSteps) return static_cast<int>(std::lround(steps));
  std::ostringstream message;
  message << "the time step is " << step << " s, so " << seconds
          << " s are more than a million steps";
  return tl::unexpected(message.str());
}

}  // namespace mjcourse
