#include <cstdio>

int main() {
  std::puts("one");
}
