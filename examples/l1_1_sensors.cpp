// Lesson 1.1, exercise: everything that the sensors of a model say, by name.
//
// INPUT    any model; here arm_and_crate.xml, its elbow bent
// PROCESS  go through the sensors; each one's numbers begin at sensor_adr and
//          are sensor_dim long
// OUTPUT   a line for each sensor; exits with 1 where they are not all of
//          sensordata
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_1_sensors

#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

using Reading = Eigen::Map<const Eigen::VectorXd>;

Reading sensor(const mjModel* model, const mjData* data, int id) {
  return {data->sensordata + model->sensor_adr[id], model->sensor_dim[id]};
}

int main() {
  const Model model = load_model("arm_and_crate");
  const Data data = make_data(model);
  const int elbow = id_of(model, mjOBJ_JOINT, "elbow");
  data->qpos[model->jnt_qposadr[elbow]] = 1.5;
  mj_forward(model, data);  // without it, all sensors read 0

  int numbers = 0;
  for (int id = 0; id < model->nsensor; ++id) {
    const char* name = mj_id2name(model, mjOBJ_SENSOR, id);
    const Reading reading = sensor(model, data, id);
    std::printf("%-14s %s\n", name ? name : "(no name)",
                to_text(reading, 3).c_str());
    numbers += static_cast<int>(reading.size());
  }
  result("numbers", numbers);
  return numbers == model->nsensordata ? 0 : 1;
}
