#include <cstdio>

int main() {
  const int joints = 3;
  std::printf("%d\n", jionts);
}
