// What a browser makes of a model's file that is opened by its address, as a site has it.
//
// MuJoCo overlooks what tells a browser to run something: elements of URDF and attributes of an
// include that it does not know, and whatever the root of an included file is.
// Tested by tests/generator/physics/model_files_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "physics/mistakes/model_error.h"

namespace mjcourse {

// Why the XML `text` of the file `path` is more to a browser than a tree of names that it does not
// know; nothing where it is no more. It must be XML for browsers as well, so that they read what
// was looked at, and it has no namespaces: without one, no browser runs anything.
std::optional<ModelError> fault_for_browsers(const std::string& path, const std::string& text);

// Whether a browser that is told no type takes a file for a page, or for XML, that begins so. Some
// servers tell none of an ending that they do not know.
bool begins_like_page(std::string_view beginning);

// So many bytes of a file browsers look at to find its type out.
inline constexpr std::size_t kLookedAt = 2048;

}  // namespace mjcourse
