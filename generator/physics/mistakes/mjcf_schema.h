// The words of MJCF: its elements and their attributes, as MuJoCo itself lists them.
//
// They are for "did you mean": MuJoCo says that `sizee` is no attribute of a geom, not what is.
#pragma once

#include <string>
#include <vector>

namespace mjcourse {

// The names of all elements, each once.
std::vector<std::string> mjcf_elements();

// The attributes of `element`, in any of the places where MJCF has one of that name.
std::vector<std::string> mjcf_attributes(const std::string& element);

}  // namespace mjcourse
