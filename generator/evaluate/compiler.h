// The C++ compiler of the examples: clang-16, or what is found.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/subprocess.h"

namespace mjcourse {

// What the compiler said about one place.
struct CompilerMessage {
  std::string file;  // as the compiler names it: what `#line` said, or a header's path
  int line = 0, column = 0;
  std::string severity;  // "error", "fatal error", "warning", "note"
  std::string text;
};

struct Compiled {
  bool succeeded = false;
  std::vector<CompilerMessage> messages;
  std::string raw;  // everything the compiler and the linker said

  // Did the compiler itself find something wrong, and not the linker or the clock?
  bool refused() const;
};

class Compiler {
 public:
  // The first of clang++-16, clang++-14, clang++, g++ that is installed; nothing when none is.
  static std::optional<Compiler> find();

  // "clang 16.0.6", "g++ 12.2.0"
  const std::string& version() const { return version_; }

  // Compile the program `source` against MuJoCo, Eigen and the helper header in the course's
  // `examples/include` into `binary`; `folder` is for files in between.
  Compiled compile(const std::filesystem::path& source, const std::filesystem::path& examples,
                   const std::filesystem::path& binary, const std::filesystem::path& folder,
                   bool optimize = false) const;

 private:
  Compiler(std::string name, std::string version)
      : name_(std::move(name)), version_(std::move(version)) {}
  std::string name_, version_;
};

}  // namespace mjcourse
