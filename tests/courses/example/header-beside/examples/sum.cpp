#include <cstdio>

#include "three.h"

int main() {
  std::printf("%d\n", kThree);
}
