// The kinds of pictures that a lesson may show.
#pragma once

#include <algorithm>
#include <string>

namespace mjcourse {

// By the end of the file's name; every browser shows these.
inline bool is_image_file(const std::string& file) {
  constexpr const char* kinds[] = {".png", ".jpg", ".jpeg", ".webp", ".svg"};
  return std::any_of(std::begin(kinds), std::end(kinds),
                     [&](const char* kind) { return file.ends_with(kind); });
}

}  // namespace mjcourse
