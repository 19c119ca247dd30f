// Several versions of one program as one program, so that they are compiled once: most of a
// compiler's time goes into headers and into the templates that all of them use.
//
// Each version is in a namespace of its own, behind the includes that they share, and its main() is
// a function there. The number of the version is the first argument. The compiler warns of nothing:
// a starter does not use what its reader is to use.
// Tested by tests/generator/evaluate/programs/joined_programs_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mjcourse {

// The lines of `versions` keep their numbers in the file `path`, as a compiler counts them. Nothing
// where the versions cannot be joined: they include otherwise, have other directives behind that,
// or a main() that is not found.
std::optional<std::string> joined_programs(const std::vector<std::string>& versions,
                                           const std::string& path);

// The arguments of the version `index` that is run with `arguments`.
std::vector<std::string> joined_arguments(std::size_t index, std::vector<std::string> arguments);

}  // namespace mjcourse
