// Author guide: how long something falls, and where it is meanwhile.
#include <mjcourse/mjcourse.hpp>

int main() {
  using namespace mjcourse;
  const double height = 1;  // m

  const Model model = load_model_xml(R"(
    <mujoco>
      <worldbody>
        <body>
          <freejoint/>
          <geom size="0.01"/>
        </body>
      </worldbody>
    </mujoco>)");
  const Data data = make_data(model);
  qpos(model, data)[2] = height;

  std::vector<double> times, heights;
  while (qpos(model, data)[2] > 0) {
    times.push_back(data->time);
    heights.push_back(qpos(model, data)[2]);
    mj_step(model, data);
  }
  std::printf("it lands after %.2f s\n", data->time);
  result("time", data->time);
  table("fall", {{"time", times}, {"height", heights}});
}
