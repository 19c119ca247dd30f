#include <cstdio>

int main() {
  std::puts("free joint");
  std::printf("nq %d nv %d\n", 7, 6);
  std::printf("norm %.4f\n", 1.0);
}
