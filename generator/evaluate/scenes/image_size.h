// How large a picture is, from its file's bytes: so that a page keeps its place before it has come.
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace mjcourse {

struct ImageSize {
  int width = 0, height = 0;
};

// Of a PNG, JPEG, WebP or SVG, as the end of `name` says. The error goes on from the file's name:
// "is not a PNG". Whether an SVG is one in all else, svg_faults.h tells.
tl::expected<ImageSize, std::string> image_size(const std::string& name, const std::string& bytes);

}  // namespace mjcourse
