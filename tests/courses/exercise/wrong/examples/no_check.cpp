#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

int answer() {
  // #region answer
  return 42;
  // #starter
  // return 0;
  // #wrong odd: it is 42
  // return 41;
  // #endregion
}

int main() {
  answer();
}
