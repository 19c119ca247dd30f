#include <mjcourse/mjcourse.hpp>
#include <vector>

int main() {
  std::vector<double> time, height;
  for (int i = 0; i <= 10; ++i) {
    time.push_back(i / 10.0);
    height.push_back(5 - 9.81 * time.back() * time.back() / 2);
  }
  mjcourse::table("heights", {{"time", time}, {"height", height}});
}
