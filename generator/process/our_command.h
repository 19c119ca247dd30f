// What a message tells its reader to type.
#pragma once

#include <string>
#include <string_view>

namespace mjcourse {

// "mjcourse"; in a checkout, whose launcher says how it was called itself (as MJCOURSE_CALLED),
// "./mjcourse".
std::string called_as();

// "`mjcourse accept`", with that name.
std::string our_command(std::string_view words);

}  // namespace mjcourse
