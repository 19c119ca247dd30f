#include "three.h"

#include <cstdio>

int main() {
  std::printf("%d\n", kThree);
}
