// The id of a heading, by which links find it, is made of its words: "Why four numbers?" is
// `why-four-numbers`.
#pragma once

#include <string>

namespace mjcourse {

// Without punctuation, whether it was typed or is typographic: "What's new" is `whats-new`. Letters
// and signs beyond ASCII stay.
std::string id_of_heading(std::string text);

}  // namespace mjcourse
