#include <cstdio>

#include "number.h"

int main() {
  std::printf("%d\n", kNumber);
}
