#include <cstdio>

int main() {
  std::puts("x");
  std::puts("");
  std::puts("\ty");
}
