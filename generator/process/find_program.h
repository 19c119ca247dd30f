// Where PATH has a program.
#pragma once

#include <filesystem>
#include <string>

namespace mjcourse {

// Empty where it has none.
std::filesystem::path find_program(const std::string& name);

}  // namespace mjcourse
