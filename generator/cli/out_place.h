// Where a command may write: a course is often somebody else's, and its `build` a link.
#pragma once

#include <optional>
#include <string_view>

#include "cli/commands.h"
#include "cli/new_files.h"

namespace mjcourse {

// What is wrong with the places that `command` is to write to: those in the course that a link
// leads out of it. A place elsewhere may be a link, as the user wants it. Throws FolderRefused
// where a folder that is to be replaced holds something that no build made.
std::optional<Refusal> refused_out(const Options& options, std::string_view command);

}  // namespace mjcourse
