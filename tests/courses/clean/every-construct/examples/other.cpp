#include <cstdio>

int main() {
  std::printf("%g\n", 3.0);
}
