// ApiEntry: a name of MuJoCo's that the course uses, as its headers declare it.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "base/source_text.h"

namespace mjcourse {

struct CodeUse {
  std::size_t page = 0, block = 0;  // Course::pages, and the block's index there
  Span place;                       // of the code, or of the fence that shows it
  std::set<int> lines;              // from 1, of a program as it is shown; none of other code
};

struct ApiEntry {
  std::string name;                     // "mj_step", "mjModel.nq"
  std::string kind;                     // in words: "function", "field of mjModel"
  std::string declaration;              // C, as the header has it
  std::string comment;                  // the header's; may be empty
  std::string header;                   // "mujoco.h"
  std::string section;                  // of the header; may be empty
  std::string url;                      // of MuJoCo's own documentation; may be empty
  std::vector<CodeUse> uses_in_code{};  // in the course's order
};

}  // namespace mjcourse
