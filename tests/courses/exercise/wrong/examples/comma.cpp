#include <mjcourse/mjcourse.hpp>
#include <utility>

int answer() {
  // #region answer
  return 42;
  // #starter
  // return 0;
  // #endregion
}

int main() {
  mjcourse::expect_near(answer(), std::pair<int, int>{42, 0}.first, 0, "it is 42");
}
