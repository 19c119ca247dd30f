// What was found, as one document for another tool: on stdout, while what a person reads goes to
// stderr.
// Tested by tests/generator/cli/verify_test.cpp.
#pragma once

#include <string>

#include "cli/commands.h"
#include "cli/verify.h"

namespace mjcourse {

// "" for Format::text.
std::string document_of(const Verified& verified, const CheckOptions& options);

}  // namespace mjcourse
