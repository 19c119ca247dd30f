#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

int answer() {
  // #region answer
  return 42;
  // #starter
  // return 1;
  // #endregion
}

int main() {
  expect(answer() > 0, "it is positive", "the sign is wrong");
  expect(answer() == 42, "it is 42");
}
