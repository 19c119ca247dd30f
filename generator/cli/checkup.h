// What this machine has of all that a course may need, found out by trying.
// Tested by tests/generator/cli/doctor_test.cpp.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/open_store.h"

namespace mjcourse {

struct Sign {
  enum class Grade {
    good,
    slow,    // all works, but slower, or with less around it
    missing  // some courses cannot be built
  };
  std::string of;  // "compiler"
  Grade grade = Grade::good;
  std::string state;  // "clang 16.0.6, mold 1.10.1"
  std::string cure;   // what to do; empty for what is good
};

// `assets` is what the site's build made, `store` a store's folder (empty: there is none). Throws
// nothing of what it finds.
std::vector<Sign> examine(const std::filesystem::path& assets, const std::filesystem::path& store);

// What the server can do that `place` or the environment names; nothing where none does. Tries to
// put a few entries there, unless it is read only.
std::optional<Sign> examine_shared(const std::filesystem::path& assets, SharedPlace place);

}  // namespace mjcourse
