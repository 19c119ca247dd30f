// An entry as a server of Bazel's protocol takes it under `ac/`.
//
// Such servers may refuse what is no ActionResult of Bazel's Remote Execution API (version 2). So
// the bytes are the standard output of one, and who signed them is its standard error. It is
// written by hand, as it has two fields: https://protobuf.dev/programming-guides/encoding/
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

struct Outputs {
  std::string output, error;  // the latter may be empty
};

std::string action_result(std::string_view output, std::string_view error = {});

// Nothing where the bytes are none, or have no output.
std::optional<Outputs> outputs_of(std::string_view action_result);

}  // namespace mjcourse
