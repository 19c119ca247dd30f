// expect() is for the program.
#pragma once

#include <mjcourse/mjcourse.hpp>

inline void check(int answer) {
  mjcourse::expect(answer == 42, "it is 42");
}
