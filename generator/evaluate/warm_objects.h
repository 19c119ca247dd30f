// WarmObjects: what programs share, compiled once: the warm header (warm_header.h) with the code of
// all that is inline in it, and the handlers that keep MuJoCo's errors from waiting on stdin.
//
// A header that makes the compiler say anything is not warmed, so that each program shows it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/prepared_files.h"
#include "evaluate/toolchain.h"

namespace mjcourse {

class WarmObjects {
 public:
  using Entry = std::shared_ptr<const PreparedFiles::Entry>;

  // What is made is kept in `cache`, or nothing is made.
  WarmObjects(Toolchain toolchain, std::optional<std::filesystem::path> cache)
      : toolchain_(std::move(toolchain)), prepared_(std::move(cache)) {}

  // header.pch and header.o of what these includes bring; `include` has the course's own headers.
  // Null where there is none to be had, and each program compiles it all.
  Entry header(const std::vector<std::string>& roots, const IncludeFolders& include);

  // handlers.o of the helper header's handlers.cpp.
  Entry handlers(const IncludeFolders& include);

  // The entry was of no use: it is made anew by who asks next, in another process.
  static void drop(const Entry& entry) { PreparedFiles::drop(*entry); }

 private:
  Toolchain toolchain_;
  PreparedFiles prepared_;
};

}  // namespace mjcourse
