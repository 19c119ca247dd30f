#include <cstdio>

int main() {
  // #region loop
  for (int i = 0; i < 2; ++i) {
    std::printf("%d\n", i);
  }
  // #endregion
}
