#include "lesson/json/tolerance.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include "lesson/json/json_object.h"

namespace mjcourse {
namespace {

constexpr double kRounding = 1e-12;  // of a number's size

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

bool Tolerance::allows(double value, double right) const {
  return std::abs(value - right) <= around(right) * (1 + kRounding) + rounding({value, right});
}

double rounding(const std::vector<double>& values) {
  double largest = 0;
  bool whole = true;
  for (const double value : values) {
    largest = std::max(largest, std::abs(value));
    whole = whole && std::trunc(value) == value;
  }
  return whole && largest < 0x1p53 ? 0 : kRounding * largest;
}

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
