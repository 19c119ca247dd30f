// "Did you mean …?": every message about an unknown name ends with the nearest known one. Scripts
// also run where there is no C++, so site/press/script/suggest.ts says it again.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

// The candidate that `name` most likely meant, by Levenshtein distance; empty when none is near
// (more than two edits and more than a third of the name away), or the name has more than 80
// characters.
std::string nearest(std::string_view name, const std::vector<std::string>& candidates);

// "did you mean `X`?" for the nearest candidate, else "known: a, b, c" (the first dozen).
std::string suggest(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace mjcourse
