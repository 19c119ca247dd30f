#include "script/collation.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "script/engine.h"
#include "script/js_value.h"

namespace mjcourse {

std::vector<std::size_t> alphabetical(const std::string& bundle, const std::string& language,
                                      const std::vector<std::string>& texts) {
  Engine engine;
  engine.load(bundle, "collate.js");
  const auto order = engine.call("collate", {language, nlohmann::json(texts).dump()});
  if (!order) throw std::runtime_error("collate.js: " + order.error().message);
  return json_of(*order).get<std::vector<std::size_t>>();
}

}  // namespace mjcourse
