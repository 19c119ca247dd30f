// Reports by itself what the helper header would, which takes long to compile.
#include <cstdlib>
#include <fstream>

int main() {
  std::ofstream file(std::getenv("MJCOURSE_RECORDS"));
  file
      << R"({"snapshot": "two_joints", "value": {"time": 1, "qpos": [0.8, 0], "qvel": [0, 0], "act": [], )"
         R"("ctrl": [], "mocap_pos": [], "mocap_quat": []}})"
      << '\n';
}
