#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

int answer() {
  // #region answer
  return 41;
  // #starter
  // return 0;
  // #wrong odd: it is 42
  // return 40;
  // #endregion
}

int main() {
  expect(answer() > 0, "it is positive", "the sign is wrong");
  expect(answer() == 42, "it is 42");
}
