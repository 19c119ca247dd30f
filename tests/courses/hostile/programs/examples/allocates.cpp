#include <vector>

int main() {
  const std::vector<char> bytes(100'000'000'000, 'x');
  return bytes.back();
}
