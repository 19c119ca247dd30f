// Says of each line of its input, a name and the known ones with tabs between them, which one was
// meant; an empty line where none is near.
#include <iostream>
#include <string>
#include <vector>

#include "base/nearest.h"

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    std::vector<std::string> words(1);
    for (const char c : line) {
      if (c == '\t') {
        words.emplace_back();
      } else {
        words.back() += c;
      }
    }
    const std::string name = words.front();
    words.erase(words.begin());
    std::cout << mjcourse::nearest(name, words) << '\n';
  }
}
