// The shared libraries that this program runs on: another build of one may compute something else.
//
// Some are loaded late (base/late_library.h), and a worker that computes has more of them than the
// process that asks. So the system's linker says which it would load, and none is loaded for that.
#pragma once

#include <map>
#include <string>

namespace mjcourse {

// A hash of their names and their linkers' build ids, the same wherever the same builds are
// installed. Asked for once; what is loaded beyond them (by Mesa, say) comes with them.
const std::string& loaded_libraries();

// The build id of each, in hexadecimal digits, by its name; empty for one that has none. Throws
// std::runtime_error where the linker does not tell.
const std::map<std::string, std::string>& library_builds();

}  // namespace mjcourse
