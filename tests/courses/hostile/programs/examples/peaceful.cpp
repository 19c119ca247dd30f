#include <cstdio>
#include <fstream>
#include <string>
#include <thread>

int main() {
  std::ofstream("note") << "all is well";
  std::string text;
  std::thread([&] { std::getline(std::ifstream("note"), text); }).join();
  std::puts(text.c_str());
}
