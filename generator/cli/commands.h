// The commands: each takes its options and gives the exit code.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mjcourse {

struct Options {
  std::filesystem::path course = ".";
  std::filesystem::path out;
  std::vector<std::string> where;  // lessons, or lines of them; none: all
  bool dry_run = false;
  std::filesystem::path report;  // a folder for the report; empty for none
  bool strict = false;           // nothing without proof or reason, and no warnings
};

// Evaluate the course and replace the site; with errors the old site stays.
int build(const Options& options);
// Evaluate the course and report.
int check(const Options& options);

// Evaluate the course and write what was computed where something else is committed.
int accept(const Options& options);

}  // namespace mjcourse
