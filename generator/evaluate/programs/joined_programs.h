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

struct Version {
  std::string text;         // of the program
  std::string before = {};  // directives in front of its own lines
  // The file of two `#line` directives; the lines between them are a stranger's, and stay as they
  // are.
  std::string marks = {};
};

// The lines of `versions` keep their numbers in the file `path`, as a compiler counts them;
// `shared` stands behind the includes. Nothing where the versions cannot be joined: they include
// otherwise, have other directives behind that, or a main() that is not found or has a region of an
// exercise, in which anything may stand.
std::optional<std::string> joined_programs(const std::vector<Version>& versions,
                                           const std::string& path, const std::string& shared = "",
                                           const std::string& at_end = "");

// One program, with `inserted` behind its leading includes.
std::string with_behind_includes(const std::string& program, const std::string& inserted,
                                 const std::string& path);

// The arguments of the version `index` that is run with `arguments`.
std::vector<std::string> joined_arguments(std::size_t index, std::vector<std::string> arguments);

}  // namespace mjcourse
