#include <fstream>

int main() {
  std::ofstream("../mjcourse-was-here") << "x";
}
