// How messages count: "1 line", "3 lines", "0 errors".
#pragma once

#include <concepts>
#include <string>

namespace mjcourse {

inline std::string counted(std::integral auto count, const std::string& one,
                           const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

inline std::string counted(std::integral auto count, const std::string& noun) {
  return counted(count, noun, noun + "s");
}

}  // namespace mjcourse
