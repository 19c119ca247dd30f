#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

double fallen(double t) {
  // #region answer
  return 9.81 * t * t / 2;
  // #starter
  // return 0;  // t = 1 s: 4.9 m
  // #wrong forgets-the-half: it falls 4.9 m
  // return 9.81 * t * t;
  // #wrong grows-evenly: twice the time
  // return 9.81 * t / 2;
  // #wrong later-only: it falls 5 cm
  // return t < 1 ? 0 : 9.81 * t * t / 2;
  // #endregion
}

int main() {
  result("metres", fallen(1));
  if (!expect_near(fallen(1), 4.905, 1e-9, "it falls 4.9 m in the first second",
                   "its speed is 9.8 m/s at the end only", 2))
    return 0;
  for (double t : {1, 2, 3}) {
    expect_near(fallen(2 * t), 4 * fallen(t), 1e-9, "twice the time is four times the way");
  }
}
