#include <cstdio>

int main() {
  std::puts("a");
  std::puts("");
  std::puts("nq 6");
  std::puts("  indented");
}
