// The period of a pendulum, for small angles. It reports its table itself, since the helper header
// takes long to compile.
#include <cmath>
#include <cstdio>
#include <cstdlib>

int main() {
  const double g = 9.81, pi = std::acos(-1.0);
  const double lengths[] = {1, 2};
  double seconds[2];
  std::puts("length   period");
  for (int i = 0; i < 2; ++i) {
    seconds[i] = 2 * pi * std::sqrt(lengths[i] / g);
    std::printf("%5.2f m  %.4f s\n", lengths[i], seconds[i]);
  }
  const char* records = std::getenv("MJCOURSE_RECORDS");
  if (records == nullptr) return 0;
  std::FILE* file = std::fopen(records, "a");
  if (file == nullptr) return 1;
  std::fputs(R"({"table": "periods", "value": [["length", [1, 2]], ["seconds", )", file);
  std::fprintf(file, "[%.17g, %.17g]]]}\n", seconds[0], seconds[1]);
  return std::fclose(file);
}
