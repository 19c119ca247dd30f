// What mends a mistake in a model: MuJoCo says what is wrong, and seldom what is right.
#pragma once

#include <string>

namespace mjcourse {

// What to do about MuJoCo's `message`; "" where only its author can know.
std::string cure_of_model(const std::string& message);

}  // namespace mjcourse
