// What `explain --json` writes on one machine, and `explain --against` reads on another: why two
// machines do not find each other's results.
// Tested by tests/generator/cli/explanation_file_test.cpp.
#pragma once

#include <map>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "evaluate/explain.h"

namespace mjcourse {

struct ExplanationFile {
  std::map<std::string, std::string> libraries;  // build ids by names
  std::map<std::string, Dependencies> tasks;     // by "FILE:LINE: WHAT"
};

ExplanationFile explanation_file(const std::vector<Explanation>& tasks);

std::string text_of(const ExplanationFile& file);
// What is wrong with a text that is none.
tl::expected<ExplanationFile, std::string> read_explanation_file(const std::string& text);

// In a few lines: of each task that both have, the first dependency that is not the same, and of
// libraries, which; tasks with the same difference are told once.
std::string differences(const ExplanationFile& here, const ExplanationFile& there);

}  // namespace mjcourse
