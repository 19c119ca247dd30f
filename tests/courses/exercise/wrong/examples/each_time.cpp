#include <mjcourse/mjcourse.hpp>

const int kTime = __COUNTER__;

int answer() {
  // #region answer
  return kTime;
  // #starter
  // return -1;
  // #endregion
}

int main() {
  mjcourse::expect_near(answer(), kTime, 0, "it is the time");
}
