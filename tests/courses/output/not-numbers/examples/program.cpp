#include <cstdio>

int main() {
  std::puts("MuJoCo 2.2.2 at 192.168.0.1");
  std::puts("0.30000000000000004");
  std::puts("9007199254740993");
  std::puts("0x1e5 12:30:05.25");
  std::puts("1234567e-1234-41d4-a716-446655440000");
  std::puts("0.25 m, 1.0e+300");
}
