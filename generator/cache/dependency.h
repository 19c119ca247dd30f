// Dependency: one thing that a result depends on, and what it was when the result was made.
//
// Names mean the same on every machine, for a store may be shared. `models/box.xml` is a file of
// the course, `/usr/include/…` one of the system, and `program l1_2_example` what a program
// reported; `text`, `MuJoCo` and `compiler` are what they say. No name or value holds where the
// course lies, a host, a user or a time.
// Tested by tests/generator/cache/fingerprints_test.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mjcourse {

struct Dependency {
  std::string name;
  std::string value;  // a SHA-256, a version, flags; "absent" for a file that was not there

  bool operator==(const Dependency&) const = default;
};
using Dependencies = std::vector<Dependency>;

inline constexpr const char* kAbsent = "absent";

// What a file is called, of a course in `root`, an absolute path without dots; `path` may be
// relative to it.
std::string file_dependency(const std::filesystem::path& path, const std::filesystem::path& root);

// What a program's reports are called as a dependency.
inline std::string program_dependency(const std::string& name) {
  return "program " + name;
}

}  // namespace mjcourse
