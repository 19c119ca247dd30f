// Reports by itself what the helper header would, which takes long to compile.
#include <cstdlib>
#include <fstream>

int main() {
  std::ofstream file(std::getenv("MJCOURSE_RECORDS"));
  file << R"({"result": "ratio", "value": null})" << '\n';
  file << R"({"result": "twice", "value": 1})" << '\n';
  file << R"({"result": "twice", "value": 2})" << '\n';
  file << R"({"table": "energy", "value": [["t", [0, 1]], ["e", [5]]]})" << '\n';
  file << R"({"snapshot": "a b", "value": {"time": 0}})" << '\n';
  file << R"({"result": "torn)";
}
