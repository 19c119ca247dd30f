#include <cstdio>

int main() {
  std::puts("old");
}
