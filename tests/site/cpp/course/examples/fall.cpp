// A ball falls for half a second.
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

int main() {
  const Model model = load_model("ball");
  const Data data = make_data(model);
  std::vector<double> time, height;
  // #region falling
  const double seconds = 0.5;
  while (data->time < seconds) {
    mj_step(model, data);
    time.push_back(data->time);
    height.push_back(data->qpos[2]);
  }
  // #endregion
  std::printf("time: %.3f s\n", data->time);
  std::printf("height: %.3f m\n", data->qpos[2]);
  result("height", data->qpos[2]);
  result("steps", height.size());
  table("fall", {{"time", time}, {"height", height}});
  snapshot("end", model, data);
}
