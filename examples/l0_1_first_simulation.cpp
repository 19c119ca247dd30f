// Lesson 0.1: a first simulation. Load, step, read.
//
// INPUT    falling_box.xml: a box 1.5 m above the floor, at rest
// PROCESS  let it fall for 250 steps; then copy the state, and take both copies
//          through the landing
// OUTPUT   time, height and velocity on the way; the height after 250 steps to the
//          last bit; whether the two copies end with the same bits
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_1_first_simulation

#include <cstdio>
#include <cstring>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

// Equal as memory: every bit, and not merely to so many digits.
bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

int main() {
  const Model model = load_model("falling_box");  // load
  const Data data = make_data(model);

  std::printf("time (s)  height (m)  velocity (m/s)\n");
  for (int n = 0; n <= 250; ++n) {
    if (n > 0) mj_step(model, data);  // step
    if (n % 50 == 0)                  // read
      std::printf("%8.3f  %10.6f  %14.4f\n", data->time, data->qpos[0],
                  data->qvel[0]);
  }
  std::printf("height after 250 steps: %.17f\n", data->qpos[0]);
  result("height", data->qpos[0]);
  result("kilobytes", data->nbuffer / 1000.);

  const Data twin = make_data(model);
  mj_copyData(twin, model, data);
  for (int n = 0; n < 250; ++n) mj_step(model, data);
  for (int n = 0; n < 250; ++n) mj_step(model, twin);
  const bool same = same_bits(data->qpos[0], twin->qpos[0]) &&
                    same_bits(data->qvel[0], twin->qvel[0]);
  std::printf("two copies, 250 steps later, same bits: %s\n",
              same ? "yes" : "no");
}
