#include <cstdio>

int main() {
  const char* name = 5;
  std::puts(name)
}
