int answer() {
  // #region answer
  return 4\
2;
  // #starter
  // return 0;
  // #endregion
}

#include <mjcourse/mjcourse.hpp>
int main() {
  mjcourse::expect(answer() == 42, "it is 42");
}
