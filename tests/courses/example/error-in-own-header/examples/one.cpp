#include "wheel.h"

int main() {
  return turns(0);
}
