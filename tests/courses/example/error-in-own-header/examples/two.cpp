#include "wheel.h"

int main() {
  return twice("one");
}
