// What a store gives, as a value: nothing where it is not of that form. A store may hold anything.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

template <typename Value>
std::optional<Value> stored_json(std::string_view bytes) {
  try {
    return nlohmann::json::parse(bytes).get<Value>();
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

template <typename Value>
std::optional<Value> stored_json(const std::optional<std::string>& bytes) {
  return bytes ? stored_json<Value>(std::string_view(*bytes)) : std::nullopt;
}

}  // namespace mjcourse
