#include "kit.hpp"

int answer() {
  // #region answer
  return 42;
  // #starter
  // return 0;
  // #endregion
}

int main() {
  check(answer());
}
