#include <cstdio>

int main() {
  for (;;) std::puts("and on, and on");
}
