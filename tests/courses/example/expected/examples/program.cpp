#include <cstdio>

int main(int, char** arguments) {
  // #region answer
  std::printf("nq of %s is 13\n", arguments[1]);
  return 3;
  // #endregion
}
