// Where a command may write: a course is often somebody else's, and its `build` a link.
// Tested by tests/generator/cli/build_test.cpp.
#pragma once

#include <filesystem>
#include <optional>
#include <system_error>

#include "cli/new_files.h"

namespace mjcourse {

// Where a command writes; empty where it does not.
struct OutPlaces {
  std::filesystem::path course = ".";
  std::filesystem::path site, report, trace, store, exercise;
};

// What is wrong with the places that a command is to write to: those in the course to which a link
// leads, those that contain the course, which would be deleted, and those where nothing can be
// written. A place elsewhere may be a link, as the user wants it. Throws FolderRefused where a
// folder that is to be replaced holds something that no build made.
std::optional<Refusal> refused_out(const OutPlaces& places);

// What the system refused in the middle of the work, as on a full disk.
Refusal failed_call(const std::system_error& error);

}  // namespace mjcourse
