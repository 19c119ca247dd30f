// Lets the raised arm fall for half a second, and records by itself what the helper header would.
#include <mujoco/mujoco.h>

#include <cstdlib>
#include <fstream>
#include <string>

int main() {
  const std::string path = std::getenv("MJCOURSE_MODELS");
  mjModel* model = mj_loadXML((path + "/swing.xml").c_str(), nullptr, nullptr, 0);
  mjData* data = mj_makeData(model);
  mj_resetDataKeyframe(model, data, 0);
  while (data->time < 0.5) mj_step(model, data);
  std::ofstream(std::getenv("MJCOURSE_RECORDS"))
      << R"({"snapshot": "fallen", "value": {"time": 0.5, "qpos": [)" << data->qpos[0] << ", "
      << data->qpos[1] << R"(], "qvel": [)" << data->qvel[0] << ", " << data->qvel[1]
      << R"(], "act": [], "ctrl": [], "mocap_pos": [], "mocap_quat": []}})" << '\n';
}
