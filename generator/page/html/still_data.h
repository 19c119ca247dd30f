// A rendered still as a page shows it: the data of picture.hbs.
// Tested by tests/generator/page/blocks/figure_data_test.cpp.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace mjcourse {

// Readers see what is at a page's top at once; all else is loaded when they come near.
enum class Loaded { at_once, when_near };

// `path` is its address without the ending; `width` and `height` are in pixels.
nlohmann::json still_data(const std::string& path, int width, int height, const std::string& alt,
                          Loaded loaded = Loaded::when_near);

}  // namespace mjcourse
