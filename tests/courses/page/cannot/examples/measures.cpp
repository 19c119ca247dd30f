#include <cstdio>

int main() {
  std::printf("%zu\n", sizeof(long));
}
