#include "physics/mistakes/lost_line.h"

#include <re2/re2.h>

#include <algorithm>
#include <ranges>
#include <sstream>

#include "base/counted.h"

namespace mjcourse {
namespace {

ModelError at(const WholeMjcf::Element& element, ModelError error) {
  error.file = element.file;
  error.line = element.line;
  return error;
}

std::size_t words_in(const std::string& text) {
  std::istringstream words(text);
  std::size_t count = 0;
  for (std::string word; words >> word;) ++count;
  return count;
}

// "object 'home': key 1: invalid qpos size, expected length 7": keyframes count from 0.
ModelError in_keyframe(ModelError error, int key, const std::string& part, int expected,
                       const WholeMjcf& whole) {
  for (const WholeMjcf::Element& element : whole.elements) {
    if (element.name != "key" || key-- > 0) continue;
    const auto given = element.attributes.find(part);
    if (given == element.attributes.end()) break;
    error.cure = "write " + counted(expected, "number") + " there, not " +
                 std::to_string(words_in(given->second));
    return at(element, std::move(error));
  }
  return error;
}

// "missing name of reference frame object in sensor '' (id = 1)": sensors count from 0.
ModelError in_sensor(ModelError error, int sensor, const WholeMjcf& whole) {
  for (const WholeMjcf::Element& element : whole.elements) {
    if (element.parent == "sensor" && sensor-- == 0) return at(element, std::move(error));
  }
  return error;
}

// The last one that says `nstack` holds.
ModelError in_stack(ModelError error, const WholeMjcf& whole) {
  for (const auto& element : std::ranges::reverse_view(whole.elements)) {
    const auto nstack = element.attributes.find("nstack");
    if (element.name != "size" || nstack == element.attributes.end()) continue;
    error.cure = "nstack=\"" + nstack->second +
                 "\" is too small for this model; without it, MuJoCo finds a size that does";
    return at(element, std::move(error));
  }
  return error;
}

ModelError in_actuators(ModelError error, const WholeMjcf& whole) {
  const auto found = std::ranges::find(whole.elements, "actuator", &WholeMjcf::Element::name);
  return found == whole.elements.end() ? error : at(*found, std::move(error));
}

}  // namespace

ModelError with_line(ModelError error, const WholeMjcf& whole,
                     const std::function<ModelError(const std::string& mjcf)>& load) {
  static const RE2 keyframe(R"(key (\d+): invalid (\w+) size, expected length (\d+)$)");
  static const RE2 of_sensor(R"( sensor '.*' \(id = (\d+)\)$)");
  if (error.line > 0) return error;
  int key = 0, expected = 0, sensor = 0;
  std::string part;
  if (RE2::PartialMatch(error.message, keyframe, &key, &part, &expected)) {
    return in_keyframe(std::move(error), key, part, expected, whole);
  }
  if (RE2::PartialMatch(error.message, of_sensor, &sensor)) {
    return in_sensor(std::move(error), sensor, whole);
  }
  if (error.message == "stateless actuators must come before stateful actuators") {
    return in_actuators(std::move(error), whole);
  }
  if (error.message == "Stack overflow") return in_stack(std::move(error), whole);
  if (!whole.includes) return error;
  const auto line = static_cast<std::size_t>(load(whole.text).line);
  if (line == 0 || line > whole.elements.size()) return error;
  return at(whole.elements[line - 1], std::move(error));
}

}  // namespace mjcourse
