#include <vector>

struct Pose {
  double angle;
};

int main() {
  std::vector<Pose> poses(3);
  return poses == poses;
}
