#include <cstdio>

int main() {
  std::printf("%.3f\n", sizeof(long) == 8 ? 1.234 : 1.235);
  std::printf("ran on %zu\n", sizeof(long));
}
