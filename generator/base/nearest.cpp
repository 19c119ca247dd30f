#include "base/nearest.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>

#include "base/code_points.h"

namespace mjcourse {
namespace {

// Longer names are no slips of the fingers, and are not listed.
constexpr std::size_t kLongest = 80;  // characters
// All suggestions of a run may take so many steps, a second, which no honest course comes near.
constexpr std::uint64_t kMostSteps = 1'000'000'000;

std::size_t edit_distance(std::u32string_view a, std::u32string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest(std::string_view name, const std::vector<std::string>& candidates) {
  static std::atomic<std::uint64_t> steps = 0;
  std::string best;
  const std::u32string wanted = code_points(name);
  if (wanted.size() > kLongest) return best;
  std::size_t best_distance = std::max<std::size_t>(2, wanted.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::u32string known = code_points(candidate);
    const std::size_t longer = std::max(wanted.size(), known.size());
    if (longer - std::min(wanted.size(), known.size()) >= best_distance) continue;
    steps += wanted.size() * known.size();
    if (steps > kMostSteps) return best;
    const std::size_t distance = edit_distance(wanted, known);
    // Two edits make any short word out of any other.
    if (distance < best_distance && distance < wanted.size()) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string suggest(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string near = nearest(name, candidates);
  if (!near.empty()) return "did you mean `" + near + "`?";
  constexpr std::size_t shown = 12;
  std::string list;
  for (std::size_t i = 0; i < std::min(shown, candidates.size()); ++i) {
    if (code_points(candidates[i]).size() <= kLongest)
      list += (list.empty() ? "" : ", ") + candidates[i];
  }
  if (candidates.size() > shown) list += ", …";
  if (candidates.empty()) return "there is none yet";
  return list.empty() ? "" : "known: " + list;
}

}  // namespace mjcourse
