// Toolchain: which compiler and which linker there are, and how they are called.
// Tested by tests/generator/toolchain/compiler_test.cpp.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "process/subprocess.h"
#include "toolchain/include_folders.h"

namespace mjcourse {

struct Toolchain {
  std::string compiler;      // the command: "clang++-16"
  std::string version;       // "clang 16.0.6", "g++ 12.2.0"
  std::string full_version;  // the compiler's own words
  std::string linker;        // of mold where it is installed, else of the system's
  bool has_mold = false;

  // The first of clang++-16, -19 and -14, clang++ and g++ that is installed; nothing when none is.
  static std::optional<Toolchain> find();

  bool is_clang() const { return compiler.starts_with("clang"); }

  // The compiler with its flags, for programs whose headers are in these folders.
  std::vector<std::string> command(bool optimize, const IncludeFolders& include) const;
};

// The flag that makes `name` what __FILE__ says of `folder`: it is to depend neither on where a
// course lies nor on a warm header.
std::string file_names_in(const std::filesystem::path& folder, const std::string& name);

// The flags in their order, without those that hold a path of the course.
std::string compile_flags(bool optimize);

// The Debian package of the compiler that we like best, by its name in this system's release.
std::string compiler_package();

inline constexpr double kToolSeconds = 120;  // wall clock

// Runs the compiler, or one of its kin, in its sandbox: it writes into `folder` alone, and reads
// that, `reads` and the system.
Outcome run_tool(std::vector<std::string> arguments, const std::filesystem::path& folder,
                 const std::vector<std::filesystem::path>& reads);

bool succeeded(const Outcome& outcome);

}  // namespace mjcourse
