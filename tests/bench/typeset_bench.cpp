// How long our typesetter takes over a list of formulas: the side of formulas.mjs that is ours.
//
//   typeset_bench BUNDLE FORMULAS PASSES
//
// BUNDLE is script/typeset.js, FORMULAS a JSON list of {"tex", "display"}. Prints the seconds of
// the first and of the last pass over all formulas as JSON.
#include <cstddef>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "base/stopwatch.h"
#include "script/typeset.h"

namespace {

std::string read(const char* path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return 2;
  const auto formulas = nlohmann::json::parse(read(arguments[2]));
  mjcourse::Typesetter typesetter(read(arguments[1]));
  double first = 0, last = 0;
  for (int pass = 0; pass < std::stoi(arguments[3]); ++pass) {
    const mjcourse::Stopwatch stopwatch;
    for (const auto& formula : formulas) {
      if (typesetter.typeset(formula["tex"], formula["display"])) continue;
      std::cerr << "not set: " << formula["tex"] << "\n";
      return 1;
    }
    last = stopwatch.seconds();
    if (pass == 0) first = last;
  }
  std::cout << nlohmann::json{{"first", first}, {"warm", last}} << "\n";
}
