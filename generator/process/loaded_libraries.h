// The shared libraries that this process runs on: a process with another build of one may compute
// something else.
#pragma once

#include <map>
#include <string>

namespace mjcourse {

// A hash of their names and their linkers' build ids, the same wherever the same builds are
// installed. Asked for once; what is loaded later (by Mesa, say) comes with what was loaded before.
const std::string& loaded_libraries();

// The build id of each, in hexadecimal digits, by its name; empty for one that has none.
const std::map<std::string, std::string>& library_builds();

}  // namespace mjcourse
