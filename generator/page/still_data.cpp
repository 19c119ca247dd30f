#include "page/still_data.h"

namespace mjcourse {

nlohmann::json still_data(const std::string& path, int width, int height, const std::string& alt,
                          Loaded loaded) {
  return {{"webp", path + ".webp"}, {"png", path + ".png"}, {"width", width},
          {"height", height},       {"alt", alt},           {"at_once", loaded == Loaded::at_once}};
}

}  // namespace mjcourse
