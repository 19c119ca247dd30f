#include <cstdio>

int main() {
  // #region loop
  for (int i = 0; i < 3; ++i) {
    const int square = i * i;

    std::printf("%d\n", square);
  }
  // #endregion
}
