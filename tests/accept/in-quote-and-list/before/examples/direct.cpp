#include <cstdio>

int main() {
  std::puts("one");
  std::puts("two");
}
