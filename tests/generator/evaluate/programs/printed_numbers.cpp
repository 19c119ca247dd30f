// Says of each three lines of its input, a stated line, a printed one and a tolerance or nothing,
// whether the two agree: 1 or 0.
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>

#include "evaluate/programs/output_diff.h"

int main() {
  for (std::string stated, printed, tolerance; std::getline(std::cin, stated) &&
                                               std::getline(std::cin, printed) &&
                                               std::getline(std::cin, tolerance);) {
    const auto most =
        tolerance.empty() ? std::nullopt : std::optional(std::strtod(tolerance.c_str(), nullptr));
    mjcourse::Retrials retrials;
    std::cout << (mjcourse::lines_agree(stated, printed, most, retrials) ? 1 : 0) << '\n';
  }
}
