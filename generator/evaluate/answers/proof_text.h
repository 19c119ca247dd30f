// The words for what a proof builds and finds, in messages and in the page.
#pragma once

#include <string>
#include <vector>

#include "lesson/blocks/quiz.h"

namespace mjcourse {

// "0.1", "1e+20": ten digits, and all of a whole number.
std::string number_text(double value);
// As many more as tell it from `other`.
std::string number_text(double value, double other);

// "a", "a and b", "a, b and c"
std::string listed(const std::vector<std::string>& words);

// How many joints of a kind the proof asks for.
int joint_count(const Proof& proof, const std::string& kind);

// What the proof builds, or the example that it asks, as a message names it: "7 hinge, 2 slide and
// 3 free joints", "pick_place".
std::string built_text(const Proof& proof);
// The same as a page names it: "a model with 1 ball joint", "pick_place.xml".
std::string built_model(const Proof& proof);

}  // namespace mjcourse
