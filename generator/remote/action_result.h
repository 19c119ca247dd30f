// An entry as a server of Bazel's protocol takes it under `ac/`.
//
// Such servers may refuse what is no ActionResult of Bazel's Remote Execution API (version 2). So
// the bytes are the standard output of one. It is written by hand, as it has one field:
// https://protobuf.dev/programming-guides/encoding/
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

std::string action_result(std::string_view output);

// The output of a result; nothing where `bytes` are none, or have no output.
std::optional<std::string> output_of(std::string_view action_result);

}  // namespace mjcourse
