#include <cstdio>

int main() {
  std::puts("as on the page");
  std::printf("a long has %zu bytes\n", sizeof(long));
  std::puts("to the end");
}
