#include <cstdio>

int main() {
  std::puts("fine");
  std::puts("a \xff");
}
