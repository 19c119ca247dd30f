// The steps of a compiler's driver: what clang starts when it is asked to compile and to link.
//
// To start clang takes 25 ms, and its driver starts it a second time. Which steps those are it
// tells (-###), and for the next program they are the same but for some names. So it is asked once
// in a process, and from then on a shell takes its place.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mjcourse {

// A command that does what `command`, clang's, does in `folder`, for a caller that wants no message
// of a step that fails: the driver has its own. `names` are the paths in it that the next such
// command may have otherwise. `reads` is as for run_tool (toolchain.h). `command` itself where the
// driver does not tell. Safe to call from several threads.
std::vector<std::string> without_driver(const std::vector<std::string>& command,
                                        const std::vector<std::string>& names,
                                        const std::filesystem::path& folder,
                                        const std::vector<std::filesystem::path>& reads);

// The commands in what `clang -###` wrote: a line each, every word of it in double quotes.
std::vector<std::vector<std::string>> parse_driver_steps(const std::string& text);

// The commands for a shell, one after the other until one fails; of `names`, the first is "$1".
std::string shell_script(const std::vector<std::vector<std::string>>& commands,
                         const std::vector<std::string>& names);

}  // namespace mjcourse
