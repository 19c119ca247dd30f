// Nothing but the standard library: no header of a course, no model.
#include <cstdio>
#include <cstdlib>

int main(int count, char** words) {
  const int lines = count > 1 ? std::atoi(words[1]) : 0;
  for (int i = 1; i <= lines; ++i) std::printf("line %d: %.3f\n", i, 1.0 / i);
  return 3;
}
