#include <mjcourse/mjcourse.hpp>

double fallen(double t) {
  // #region answer
  // #endregion
}

int main() {
  mjcourse::expect_near(fallen(0.1), 0.04905, 1e-9, "it falls 5 cm in 0.1 s");
}
