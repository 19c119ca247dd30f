// LentHeaders: the headers beside its program that a stranger's text may include.
//
// The folder of a program has the other programs of the course, its solutions and hidden checks
// among them. A text that is compiled in there could copy them into its own program. So it gets a
// folder with copies of those headers alone that the program includes, and what these include.
// Tested by tests/generator/actions/lent_headers_test.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "toolchain/compiler.h"

namespace mjcourse {

// The headers of `files` that a program beside them includes, and those that these include: their
// names in there, sorted.
std::vector<std::string> included_headers(const DiskFiles& files, std::string_view program);

class LentHeaders {
 public:
  // Copies from the folder `from`, whose links that lead out of it and whose pipes are left out,
  // into `to`, which must not be there. `program` is what includes them.
  LentHeaders(std::filesystem::path from, std::filesystem::path to, std::string_view program);

  // The copies are there; "" where nothing is included.
  const std::filesystem::path& folder() const { return to_; }

  // Names the files themselves where the compiler named copies.
  void name_originals(Compiled& compiled) const;

 private:
  std::string original_of(const std::string& path) const;

  std::filesystem::path from_, to_;
};

}  // namespace mjcourse
