// CBOR that somebody else may have written: what a store has, and what a worker says.
// Tested by tests/generator/evaluate/codec/result_codec_test.cpp.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

std::string to_cbor(const nlohmann::json& value);

// Nothing where the bytes are no CBOR, have a text that is not UTF-8, or lists in lists beyond any
// need: the library calls itself for each.
std::optional<nlohmann::json> from_cbor(std::string_view bytes);

}  // namespace mjcourse
