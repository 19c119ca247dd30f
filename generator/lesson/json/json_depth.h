// How deep lists and objects of JSON may be nested in a lesson.
#pragma once

#include <cstddef>

namespace mjcourse {

// Its readers recurse; no lesson needs a tenth of this.
inline constexpr std::size_t kDeepestJson = 200;

}  // namespace mjcourse
