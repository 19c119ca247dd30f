// A picture in memory, the two files it can become, and the one that it can come from.
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace mjcourse {

struct Picture {
  int width = 0;                  // pixels
  int height = 0;                 // pixels
  std::vector<std::uint8_t> rgb;  // (height x width x 3), the top row first
};

// The bytes of a WebP file: lossy, with sharp colour edges for the thin axes of frames. The same
// picture gives the same bytes.
std::string encode_webp(const Picture& picture);

// The bytes of a PNG file, for browsers without WebP. The same picture gives the same bytes.
std::string encode_png(const Picture& picture);

// The picture in a PNG file of any kind, what is transparent in it black; or why it cannot be read.
tl::expected<Picture, std::string> decode_png(const std::string& bytes);

}  // namespace mjcourse
