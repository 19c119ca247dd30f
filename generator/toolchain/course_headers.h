// CourseHeaders: a course's own headers under names that are the same wherever the course lies.
//
// A compiled header knows the path of each file that went into it, so one that was made of a course
// in one folder would be of no use to the same course in another. So the compiler that makes one,
// and each that uses it, sees the include folders under fixed names, through a virtual file system
// (clang's -ivfsoverlay). Under these, the headers of two checkouts are the same files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "toolchain/include_folders.h"

namespace mjcourse {

class CourseHeaders {
 public:
  // The file that a compiled header is made of, as the compiler sees it.
  static constexpr const char* kSource = "/mjcourse/header.hpp";

  explicit CourseHeaders(const IncludeFolders& folders);

  // The folders as the compiler sees them, in their order.
  const IncludeFolders& shown() const { return shown_; }
  // What is behind a path that the compiler names: of a shown file the true one, else the same.
  std::string true_path(const std::string& path) const;
  // The virtual file system, for -ivfsoverlay; with `source`, kSource is that file.
  std::string overlay(const std::optional<std::filesystem::path>& source) const;
  // What headers there are: the name and the hash of each, without a path of the course.
  std::string contents() const;

 private:
  IncludeFolders folders_, shown_;
};

}  // namespace mjcourse
