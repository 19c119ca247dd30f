// Lesson 1.1, exercise: everything that the sensors of a model say, by name.
//
// INPUT    any model; here arm_and_crate.xml, its elbow bent
// PROCESS  go through the sensors; each one's numbers begin at sensor_adr and
//          are sensor_dim long
// OUTPUT   a line for each sensor; checks that they are all of sensordata, and
//          two of them against other results; the same for another model
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_1_sensors

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::Map, Eigen::Vector3d, Eigen::Vector4d, Eigen::VectorXd;

// All numbers of the sensor `id`, as the last mj_forward or mj_step left them.
VectorXd sensor(const mjModel* model, const mjData* data, int id) {
  // #region answer
  return Map<const VectorXd>(data->sensordata + model->sensor_adr[id],
                             model->sensor_dim[id]);
  // #starter
  // return VectorXd();  // where do its numbers begin, and how many are there?
  // #wrong one-number-each: no number is left out
  // return Map<const VectorXd>(data->sensordata + model->sensor_adr[id], 1);
  // #wrong id-for-address: each sensor has its own numbers
  // return Map<const VectorXd>(data->sensordata + id, model->sensor_dim[id]);
  // #wrong this-arm-only: another model's sensors are read, too
  // const int begin[] = {0, 3, 4}, size[] = {3, 1, 1};
  // return Map<const VectorXd>(data->sensordata + begin[id], size[id]);
  // #endregion
}

// A site on a hinge, and three sensors without names.
constexpr const char* kOther = R"(<mujoco>
  <worldbody>
    <body> <joint name="hinge"/> <geom size="0.1"/> <site name="site"/> </body>
  </worldbody>
  <sensor>
    <jointpos joint="hinge"/>
    <framequat objtype="site" objname="site"/>
    <gyro site="site"/>
  </sensor>
</mujoco>)";

int main() {
  const Model model = load_model("arm_and_crate");
  const Data data = make_data(model);
  const int elbow = id_of(model, mjOBJ_JOINT, "elbow");
  data->qpos[model->jnt_qposadr[elbow]] = 1.5;
  mj_forward(model, data);  // without it, all sensors read 0

  int numbers = 0;
  for (int id = 0; id < model->nsensor; ++id) {
    const char* name = mj_id2name(model, mjOBJ_SENSOR, id);
    const VectorXd reading = sensor(model, data, id);
    std::printf("%-14s %s\n", name ? name : "(no name)",
                to_text(reading, 3).c_str());
    numbers += static_cast<int>(reading.size());
  }
  result("numbers", numbers);
  if (!expect(numbers == model->nsensordata, "no number is left out",
              "the sensors together have nsensordata numbers"))
    return 0;

  const auto by_name = [&](const char* name) {
    return sensor(model, data, id_of(model, mjOBJ_SENSOR, name));
  };
  const int hand = id_of(model, mjOBJ_SITE, "hand");
  const char* own = "each sensor has its own numbers";
  const char* others = "an id is not the place where its numbers begin";
  const bool is_hand =
      expect_near(by_name("hand_position"),
                  Vector3d(data->site_xpos + 3 * hand), 1e-12, own, others);
  const bool is_elbow = expect_near(
      by_name("elbow_angle"), VectorXd::Constant(1, 1.5), 1e-12, own, others);
  if (!is_hand || !is_elbow) return 0;

  const Model other = load_model_xml(kOther);
  const Data turned = make_data(other);
  turned->qpos[0] = 0.8;  // rad, about z
  mj_forward(other, turned);
  expect_near(sensor(other, turned, 1),
              Vector4d(std::cos(0.4), 0, 0, std::sin(0.4)), 1e-12,
              "another model's sensors are read, too",
              "the arm's addresses and lengths are not those of every model");
}
