// A picture made small, as a lesson's reference pictures are.
#pragma once

#include "physics/picture.h"

namespace mjcourse {

// `picture` at `width` x `height`, which are not larger than its own. Each pixel is the mean of the
// area that it stands for, so one that flips at an edge weighs no more than that part of the area.
Picture shrink(const Picture& picture, int width, int height);

}  // namespace mjcourse
