#include "lesson/tolerance.h"

#include <charconv>
#include <optional>
#include <string>

#include "lesson/json_object.h"

namespace mjcourse {
namespace {

// 0.01 for "1%" and "1 %".
std::optional<double> read_percentage(const std::string& text) {
  if (!text.ends_with('%')) return std::nullopt;
  const std::size_t end = text.find_last_not_of(" %") + 1;
  double percent = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + end, percent);
  if (error != std::errc() || stop != text.data() + end) return std::nullopt;
  return percent / 100;
}

}  // namespace

Tolerance read_tolerance(JsonObject& object, Reading& reading) {
  const JsonValue* value = object.find("tol");
  if (value == nullptr) return {};
  const std::string expected = "a number, or a percentage: \"1%\"";
  std::optional<double> amount = value->number;
  const bool relative = value->kind == JsonValue::Kind::string;
  if (relative) {
    amount = read_percentage(value->string.text);
  } else if (value->kind != JsonValue::Kind::number) {
    report_kind("tol", *value, expected, reading);
    return {};
  }
  if (amount && *amount >= 0 && std::isfinite(*amount)) return {*amount, relative};
  reading.error("E-json-range", value->span,
                "\"tol\" says how far an answer may be off: " + expected);
  return {};
}

}  // namespace mjcourse
