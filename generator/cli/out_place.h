// Where a command may write: a course is often somebody else's, and its `build` a link.
#pragma once

#include <optional>
#include <string_view>
#include <system_error>

#include "cli/commands.h"
#include "cli/new_files.h"

namespace mjcourse {

// What is wrong with the places that `command` is to write to: those in the course that a link
// leads out of it, and those where nothing can be written. A place elsewhere may be a link, as the
// user wants it. Throws FolderRefused where a folder that is to be replaced holds something that no
// build made.
std::optional<Refusal> refused_out(const Options& options, std::string_view command);

// What the system refused in the middle of the work, as on a full disk.
Refusal failed_call(const std::system_error& error);

}  // namespace mjcourse
