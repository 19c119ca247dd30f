// The edits of many diagnostics, gathered by file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "report/diagnostic.h"

namespace mjcourse {

struct FileEdit {
  std::string file;                   // relative to the course
  std::optional<std::string> before;  // its bytes; nothing where it is not there
  std::string after;
  std::vector<const Diagnostic*> cures;  // what it mends
};

// A diagnostic whose edit contradicts another's, or is of a file that is not as it was.
struct RefusedEdit {
  const Diagnostic* diagnostic;
  std::string cure;  // of what is in the way
};

struct FileEdits {
  std::vector<FileEdit> files;  // in the order of the diagnostics
  std::vector<RefusedEdit> refused;
};

// The cure of an edit that came too late.
std::string changed_meanwhile(const std::string& file);

// `wanted` have edits. Several of one file are made together.
FileEdits gather_edits(const std::vector<const Diagnostic*>& wanted, const Files& files);

}  // namespace mjcourse
