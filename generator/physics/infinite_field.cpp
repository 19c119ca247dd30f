#include "physics/infinite_field.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "physics/field_table.h"

namespace mjcourse {
namespace {

template <typename Number>
int first_infinite(const mjcField& field) {
  const auto* numbers = static_cast<const Number*>(field.address);
  const auto* end = numbers + static_cast<std::ptrdiff_t>(field.rows) * field.columns;
  const auto* found = std::find_if(numbers, end, [](Number x) { return !std::isfinite(x); });
  return found == end ? -1 : static_cast<int>(found - numbers);
}

}  // namespace

std::string find_infinite_field(Model& model) {
  const int count = mjc_model_fields(model.get(), nullptr, 0);
  std::vector<mjcField> fields(static_cast<std::size_t>(count));
  mjc_model_fields(model.get(), fields.data(), count);
  for (const mjcField& field : fields) {
    int at = -1;
    if (field.type == mjcFIELD_DOUBLE) at = first_infinite<mjtNum>(field);
    if (field.type == mjcFIELD_FLOAT) at = first_infinite<float>(field);
    if (at < 0) continue;
    const std::string owner = field.owner;
    return (owner.empty() ? "" : owner + ".") + field.name +
           (field.scalar != 0 ? "" : "[" + std::to_string(at) + "]");
  }
  return "";
}

}  // namespace mjcourse
