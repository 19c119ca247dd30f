#include "evaluate/programs/record_diff.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <variant>
#include <vector>

namespace mjcourse {
namespace {

// Relative; and absolute, where sums cancel to nothing.
constexpr double kRelative = 1e-5, kAbsolute = 1e-9;

bool agree(double a, double b) {
  return a == b ||
         std::abs(a - b) <= std::max(kAbsolute, kRelative * std::max(std::abs(a), std::abs(b)));
}

bool agree(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return agree(x, y); });
}

bool agree(const Reported& a, const Reported& b) {
  return std::visit(
      [&](const auto& known) {
        using T = std::decay_t<decltype(known)>;
        const T* other = std::get_if<T>(&b);
        if (other == nullptr) return false;
        if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::vector<double>>) {
          return agree(known, *other);
        } else {
          return known == *other;
        }
      },
      a);
}

bool agree(const Table& a, const Table& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Column& x, const Column& y) {
    return x.name == y.name && agree(x.values, y.values);
  });
}

bool agree(const State& a, const State& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.first == y.first && agree(x.second, y.second);
  });
}

// Of a table and a snapshot, whose numbers are too many for a line.
template <typename Value>
std::string shown(const Value& /*value*/) {
  return "";
}

std::string shown(const Reported& value) {
  if (const auto* number = std::get_if<double>(&value)) return nlohmann::json(*number).dump();
  const auto* text = std::get_if<std::string>(&value);
  return text == nullptr ? "" : "\"" + *text + "\"";
}

template <typename Value>
std::string first_difference(const std::string& kind, const std::map<std::string, Value>& native,
                             const std::map<std::string, Value>& page) {
  for (const auto& [name, value] : native) {
    const std::string what = "the " + kind + " `" + name + "`";
    const auto other = page.find(name);
    if (other == page.end()) return what + " is missing there";
    if (agree(value, other->second)) continue;
    const std::string here = shown(value), there = shown(other->second);
    if (here.empty() || there.empty() || here == there) return what + " is another";
    return what + " is " + there + " there, and " + here + " natively";
  }
  for (const auto& [name, value] : page) {
    if (!native.contains(name)) return "the " + kind + " `" + name + "` is there alone";
  }
  return "";
}

}  // namespace

std::string record_diff(const Records& native, const Records& page) {
  for (const std::string& found : {first_difference("result", native.results, page.results),
                                   first_difference("table", native.tables, page.tables),
                                   first_difference("snapshot", native.snapshots, page.snapshots),
                                   check_diff(native.checks, page.checks)}) {
    if (!found.empty()) return found;
  }
  return "";
}

std::string check_diff(const std::vector<Check>& native, const std::vector<Check>& page) {
  for (const Check& check : native) {
    const auto other = std::ranges::find(page, check.what, &Check::what);
    const std::string what = "the check `" + check.what + "`";
    if (other == page.end()) return what + " is not made there";
    if (other->holds != check.holds) {
      return what + (other->holds ? " holds there, and not natively" : " fails there");
    }
  }
  for (const Check& check : page) {
    if (std::ranges::count(native, check.what, &Check::what) == 0) {
      return "the check `" + check.what + "` is made there alone";
    }
  }
  return "";
}

}  // namespace mjcourse
