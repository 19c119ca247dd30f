// WarmObjects: what programs share, compiled once: the warm header (warm_header.h), and the
// handlers that keep MuJoCo's errors from waiting on stdin.
//
// Making a header is an investment, so it is for a caller to decide (shared_headers.h): compiling a
// program waits for none. They are of two kinds. Making a quick one takes little longer than
// compiling one program; with it, a program compiles in a fifth of the time. A thorough one holds
// what programs mostly do with Eigen (warm_eigen.hpp) as well, and comes with an object of all that
// is inline in it, optimised. It takes ten times as long, and so is for many programs; these are
// then compiled and run in half of the time that the quick one leaves.
//
// A header that makes the compiler say anything is not warmed, so that each program shows it. No
// path of the course is in what is kept (course_headers.h), so that all checkouts share it.
// Tested by tests/generator/toolchain/warm_header_test.cpp.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cache/prepared_folders.h"
#include "toolchain/course_headers.h"
#include "toolchain/toolchain.h"

namespace mjcourse {

enum class Warmth { quick, thorough };

class WarmObjects {
 public:
  using Entry = std::shared_ptr<const PreparedFolders::Entry>;

  // Of a course whose headers are in these folders. What is made is kept in `prepared`, or nothing
  // is made.
  WarmObjects(Toolchain toolchain, std::optional<std::filesystem::path> prepared,
              const IncludeFolders& include);

  const CourseHeaders& headers() const { return headers_; }

  bool makes_headers() const { return toolchain_.is_clang() && prepared_.keeps(); }
  // header.pch of what these includes bring, and of a thorough one header.o; the best that was made
  // before. Null where there is none, and each program compiles it all.
  Entry header(const std::vector<std::string>& roots);
  // It was not made before: make it now. For a compiler that can make none, this is nothing.
  void make_header(const std::vector<std::string>& roots, Warmth warmth);

  // handlers.o of the helper header's handlers.cpp.
  Entry handlers();

  // The entry was of no use: it is made anew by the next caller, in another process.
  static void drop(const Entry& entry) { PreparedFolders::drop(*entry); }

 private:
  std::string request(const std::string& what) const;

  Toolchain toolchain_;
  IncludeFolders include_;
  CourseHeaders headers_;
  std::string contents_;  // of the headers, when this was made
  PreparedFolders prepared_;
};

}  // namespace mjcourse
