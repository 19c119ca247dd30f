#include <fstream>
#include <string>

int main() {
  std::ofstream file("file");
  const std::string text(1 << 20, 'x');
  for (;;) file << text << std::flush;
}
