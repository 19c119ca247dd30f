// Author guide: a program with arguments, which ends as its lesson expects.

#include <cstdio>
#include <cstdlib>

int main(int count, char** words) {
  for (int i = 1; i < count; ++i) std::printf("%d: %s\n", i, words[i]);
  return count - 1;
}
