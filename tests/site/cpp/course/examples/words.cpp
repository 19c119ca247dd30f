// Nothing but the standard library: what it is told, and an exit code.
#include <cstdio>

int main(int count, char** words) {
  for (int i = 1; i < count; ++i) std::printf("%d: %s\n", i, words[i]);
  return 3;
}
