#include <cstdio>

int main() {
  std::puts("fine");
  std::puts("\033[1mbold");
}
