// The bundles that site/bundle/build.mjs wrote, as the generator gets them.
#pragma once

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace mjcourse {

// The text of script/`name`.js; MJCOURSE_ASSETS is the folder that site/bundle/build.mjs wrote.
inline std::string bundle(const std::string& name) {
  const std::string path = MJCOURSE_ASSETS "/script/" + name + ".js";
  std::ifstream file(path);
  if (!file) throw std::runtime_error("no bundle " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace mjcourse
