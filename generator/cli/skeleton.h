// Skeletons: what a new lesson, model, example, exercise or course begins with. They are files of
// the assets, in skeleton/ (cli/skeleton in the sources), with marks as `@name@` for what is not
// the same in each.
#pragma once

#include <map>
#include <string>

#include "base/files.h"

namespace mjcourse {

// The skeleton `path` ("lesson.md") with a text for each of its marks; nothing else in it is
// touched. Throws std::runtime_error where there is no such skeleton, or no text for a mark.
std::string filled_skeleton(const Files& assets, const std::string& path,
                            const std::map<std::string, std::string>& marks);

}  // namespace mjcourse
