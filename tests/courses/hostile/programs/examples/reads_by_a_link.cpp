#include <filesystem>
#include <fstream>
#include <iostream>

int main() {
  std::filesystem::create_symlink("/etc/passwd", "mine");
  std::cout << std::ifstream("mine").rdbuf();
}
