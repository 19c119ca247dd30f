// Lesson 0.1, challenge: which numbers bring a simulation back?
//
// INPUT    falling_box.xml
// PROCESS  at each of 500 steps, save some of the state; take 100 steps more;
//          put what was saved into fresh data, take those 100 steps again
// OUTPUT   how many of the 500 replays end at another height: one that saved
//          time, qpos and qvel, and one that saved the warm start as well
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_1_rewind

#include <cstdio>
#include <cstring>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::VectorXd;

// Copies of a state's numbers; the box has no actuators, so there is no act.
struct Saved {
  double time;
  VectorXd qpos, qvel, warmstart;
};

Saved save(const Model& model, const Data& data) {
  return {data->time, qpos(model, data), qvel(model, data),
          VectorView(data->qacc_warmstart, model->nv)};
}

// Fresh data with what was saved in it, with or without the warm start.
Data restore(const Model& model, const Saved& saved, bool warm) {
  Data data = make_data(model);
  data->time = saved.time;
  qpos(model, data) = saved.qpos;
  qvel(model, data) = saved.qvel;
  if (warm) VectorView(data->qacc_warmstart, model->nv) = saved.warmstart;
  return data;
}

double height_later(const Model& model, const Data& data) {
  for (int n = 0; n < 100; ++n) mj_step(model, data);
  return data->qpos[0];
}

// Whether the replay ends with other bits than the original.
bool differs(const Model& model, const Saved& saved, bool warm,
             double original) {
  const double replayed = height_later(model, restore(model, saved, warm));
  return std::memcmp(&replayed, &original, sizeof original) != 0;
}

int main() {
  const Model model = load_model("falling_box");
  const Data data = make_data(model), original = make_data(model);
  int in_the_air[2] = {}, on_the_floor[2] = {};  // [with the warm start]
  for (int n = 0; n < 500; ++n) {
    const bool falling = data->time < 0.34;  // and the 100 steps after it
    const Saved saved = save(model, data);
    mj_copyData(original, model, data);
    const double height = height_later(model, original);
    for (const bool warm : {false, true})
      (falling ? in_the_air : on_the_floor)[warm] +=
          differs(model, saved, warm, height);
    mj_step(model, data);
  }
  const auto word = [](int count) { return count == 0 ? "none" : "some"; };
  std::printf("replays that end with other bits  in the air  landing\n");
  std::printf("time, qpos, qvel                  %-10s  %s\n",
              word(in_the_air[false]), word(on_the_floor[false]));
  std::printf("and qacc_warmstart                %-10s  %s\n",
              word(in_the_air[true]), word(on_the_floor[true]));
  result("differ", on_the_floor[false]);
}
