// What MJCF has gained since the MuJoCo that we are built on, and with which version.
//
// Most models that a reader finds today are of a newer MuJoCo. "Unrecognized attribute" sounds as
// if they were wrong; these say from which version on they are right.
#pragma once

#include <string>

namespace mjcourse {

// The version that brought it, such as "2.3.1"; "" for what we know nothing of.
std::string since_when_element(const std::string& element);
std::string since_when_attribute(const std::string& element, const std::string& attribute);
// Of a value: `implicitfast` of an `option`.
std::string since_when_keyword(const std::string& element, const std::string& keyword);

}  // namespace mjcourse
