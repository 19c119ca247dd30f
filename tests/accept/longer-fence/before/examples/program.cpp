#include <cstdio>

int main() {
  std::puts("```");
  std::puts("````cpp");
  std::puts("x");
}
