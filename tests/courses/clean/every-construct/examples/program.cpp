#include <cstdio>

int main() {
  std::printf("mass   %.3f kg\n", 1.5);
  std::printf("bodies %d\n", 2);
}
