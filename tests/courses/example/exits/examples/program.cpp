#include <cstdio>

int main() {
  std::puts("prediction and model agree: no");
  std::fputs("nq is 13, not 14\n", stderr);
  return 3;
}
