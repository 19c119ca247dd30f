#include <cstdio>

int main() {
  std::fputs("waiting for the arm to stop\n", stderr);
  for (volatile int turn = 0;; turn = turn + 1) {
  }
}
