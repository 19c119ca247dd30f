// Lesson 3.2: which force a force sensor reads, and in which frame.
//
// INPUT    weigh_tray.xml: a tray on a wrist, a ball on the tray
// PROCESS  read force, torque and touch: level, with a push from outside, and
//          with the tray tilted; work out what the arm must exert on the tray
// OUTPUT   the readings, and the force in the world's frame
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_2_force_torque

#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::Map, Eigen::Matrix3d, Eigen::Vector3d;

int main() {
  const Model model = load_model("weigh_tray");
  const Data data = make_data(model);
  const int tray = id_of(model, mjOBJ_BODY, "tray");
  const int ball = id_of(model, mjOBJ_BODY, "ball");
  const int wrist = id_of(model, mjOBJ_SITE, "wrist");
  const auto settle = [&](double seconds) {
    const double end = data->time + seconds;
    while (data->time < end) mj_step(model, data);
    mj_forward(model, data);  // the sensors of now
  };

  // #region read
  const auto read = [&](const char* name) -> const mjtNum* {
    const int id = id_of(model, mjOBJ_SENSOR, name);
    return data->sensordata + model->sensor_adr[id];
  };
  const auto show = [&](const char* when) {
    const Vector3d force(read("force")), torque(read("torque"));
    const Map<const Matrix3d> columns(data->site_xmat + 9 * wrist);
    const Matrix3d R = columns.transpose();  // MuJoCo's rows
    std::printf("%s\n", when);
    std::printf("  force %s  in the world %s\n", to_text(force, 2).c_str(),
                to_text(R * force, 2).c_str());
    std::printf("  torque about y %6.3f  touch: left %.3f, right %.3f\n",
                torque[1], read("left")[0], read("right")[0]);
  };
  settle(1);
  show("level");
  // #endregion

  // #region expected
  // The arm's force on the tray carries both, and its torque keeps them level.
  const double g = 9.81, weight = g * model->body_mass[tray];
  const double load = g * model->body_mass[ball];
  const Vector3d at(data->site_xpos + 3 * wrist);
  const double torque = -weight * (data->xipos[3 * tray] - at[0]) -
                        load * (data->xipos[3 * ball] - at[0]);
  std::printf("worked out\n  force %.3f N, torque %.3f N m\n", weight + load,
              torque);
  // #endregion

  result("force", read("force")[2]);
  result("torque", read("torque")[1]);
  result("touch", read("right")[0]);

  // #region push
  data->xfrc_applied[6 * tray + 2] = -1;  // N, down, at the tray's centre
  settle(1);
  show("pushed down by 1 N");
  // #endregion
  data->xfrc_applied[6 * tray + 2] = 0;
  settle(1);

  for (int i = 1; i <= 100; ++i) {  // gently
    data->ctrl[0] = 0.3 * i / 100;
    settle(0.01);
  }
  settle(2);
  show("lowered by 0.3 rad");
  result("along", read("force")[0]);
  result("tilted_touch", read("right")[0]);
}
