// The commands: each takes its options and gives the exit code.
#pragma once

#include <filesystem>

namespace mjcourse {

struct Options {
  std::filesystem::path course = ".";
  std::filesystem::path out;
  std::filesystem::path report;  // a folder for the report; empty for none
  bool strict = false;           // nothing without proof or reason, and no warnings
};

// Evaluate the course and replace the site; with errors the old site stays.
int build(const Options& options);
// Evaluate the course and report.
int check(const Options& options);

}  // namespace mjcourse
