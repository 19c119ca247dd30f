#include "cli/size.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace mjcourse {
namespace {

struct Unit {
  std::string_view name;
  double bytes;
};
constexpr std::array kUnits{Unit{"TB", 1e12}, Unit{"GB", 1e9}, Unit{"MB", 1e6}, Unit{"kB", 1e3}};

}  // namespace

std::optional<std::uintmax_t> read_size(const std::string& text) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number, std::chars_format::fixed);
  if (read.ec != std::errc() || !std::isfinite(number) || number < 0) return std::nullopt;
  const std::string_view unit(read.ptr, static_cast<std::size_t>(end - read.ptr));
  double bytes = unit.empty() ? 1 : 0;
  for (const Unit& known : kUnits) {
    if (unit == known.name || (unit == "KB" && known.name == "kB")) bytes = known.bytes;
  }
  if (bytes == 0 || number * bytes > 1e18) return std::nullopt;
  return static_cast<std::uintmax_t>(std::llround(number * bytes));
}

std::string size_text(std::uintmax_t bytes) {
  for (const Unit& unit : kUnits) {
    if (static_cast<double>(bytes) < unit.bytes) continue;
    char text[32];
    std::snprintf(text, sizeof text, "%.3g ", static_cast<double>(bytes) / unit.bytes);
    return text + std::string(unit.name);
  }
  return std::to_string(bytes) + (bytes == 1 ? " byte" : " bytes");
}

}  // namespace mjcourse
