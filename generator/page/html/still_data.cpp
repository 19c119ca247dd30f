#include "page/html/still_data.h"

#include "page/html/site_paths.h"

namespace mjcourse {

nlohmann::json still_data(const std::string& path, int width, int height, const std::string& alt,
                          Loaded loaded) {
  const std::string address = site_address(path);
  return {{"webp", address + ".webp"},
          {"png", address + ".png"},
          {"width", width},
          {"height", height},
          {"alt", alt},
          {"at_once", loaded == Loaded::at_once}};
}

}  // namespace mjcourse
