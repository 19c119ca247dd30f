#include <fstream>
#include <string>

int main() {
  const std::string text(1 << 20, 'x');
  for (int i = 0;; ++i) std::ofstream("file" + std::to_string(i)) << text;
}
