// Lesson 2.4, exercise: a target that makes the hand arrive in time.
//
// INPUT    mocap_hands.xml, without gravity: hands of 1 kg and 10 kg, each
//          welded to a target
// PROCESS  say where the targets must be so that the hands keep to a path; move
//          the targets; measure how far the hands are off
// OUTPUT   the largest error on a circle, without a lead and with it; checks a
//          line, a circle, and another damping ratio
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_4_lead

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

// Where a hand should be at an instant, and how it should move there.
struct Motion {
  Eigen::Vector3d place, velocity, acceleration;  // m, m/s, m/s^2
};

// Where the target must be at that instant. The weld has the time constant
// `time` and the damping ratio `ratio`, and an impedance that is always dmax.
Eigen::Vector3d target_for(const Motion& wanted, double time, double ratio) {
  // #region answer
  // The hand's acceleration is -(2 / T) v - r / (ratio T)^2: solve for r.
  const Eigen::Vector3d ahead =
      2 * time * wanted.velocity + time * time * wanted.acceleration;
  return wanted.place + ratio * ratio * ahead;
  // #starter
  // (void)time, (void)ratio;
  // return wanted.place;  // the hand will be late
  // #wrong forgets-the-acceleration: on a circle
  // return wanted.place + 2 * ratio * ratio * time * wanted.velocity;
  // #wrong lags-twice-as-much: on a line
  // const Eigen::Vector3d ahead =
  //     2 * time * wanted.velocity + time * time * wanted.acceleration;
  // return wanted.place - ratio * ratio * ahead;
  // #wrong leads-by-one-time-constant: on a line
  // (void)ratio;
  // return wanted.place + time * wanted.velocity;
  // #wrong ignores-the-ratio: with another damping ratio
  // (void)ratio;
  // return wanted.place + 2 * time * wanted.velocity +
  //        time * time * wanted.acceleration;
  // #wrong scales-by-the-ratio-once: with another damping ratio
  // return wanted.place + ratio * (2 * time * wanted.velocity +
  //                                time * time * wanted.acceleration);
  // #endregion
}

using Path = std::function<Motion(double time)>;

Motion line(double time) {
  const Eigen::Vector3d along(0, -0.3, 0.4);
  return {along * time, along, Eigen::Vector3d::Zero()};
}

// A turn each second, with a radius of 10 cm.
Motion circle(double time) {
  const double rate = 2 * M_PI, angle = rate * time;
  const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0);
  const Eigen::Vector3d on(-std::sin(angle), std::cos(angle), 0);
  return {0.1 * out, 0.1 * rate * on, -0.1 * rate * rate * out};
}

// The largest error (mm) in the last of three seconds, of both hands.
double largest_error(const Model& model, const Path& path, bool lead,
                     double time, double ratio) {
  for (int weld = 0; weld < 2; ++weld) {
    model->eq_solref[mjNREF * weld] = time;
    model->eq_solref[mjNREF * weld + 1] = ratio;
    model->eq_solimp[mjNIMP * weld] = model->eq_solimp[mjNIMP * weld + 1];
  }
  const Data data = make_data(model);
  using Place = Eigen::Map<Eigen::Vector3d>;
  const Eigen::Vector3d light = Place(data->mocap_pos);
  const Eigen::Vector3d heavy = Place(data->mocap_pos + 3);
  double error = 0;
  for (; data->time < 3; mj_step(model, data)) {
    const Motion wanted = path(data->time);
    const Eigen::Vector3d target =
        lead ? target_for(wanted, time, ratio) : wanted.place;
    Place(data->mocap_pos) = light + target;
    Place(data->mocap_pos + 3) = heavy + target;
    if (data->time < 2) continue;
    const Eigen::Vector3d first = Place(data->qpos) - light - wanted.place;
    const Eigen::Vector3d second = Place(data->qpos + 7) - heavy - wanted.place;
    error = std::max({error, first.norm(), second.norm()});
  }
  return 1000 * error;
}

int main() {
  const Model model = load_model("mocap_hands");
  model->opt.gravity[2] = 0;
  model->opt.timestep = 0.001;
  model->opt.disableflags |= mjDSBL_CONTACT;  // the crate is in the way

  const double without = largest_error(model, circle, false, 0.05, 1);
  const double with = largest_error(model, circle, true, 0.05, 1);
  std::printf("a circle of 100 mm, T = 0.05 s\n");
  std::printf("without a lead, off by %.1f mm\n", without);
  std::printf("with a lead, off by    %.1f mm\n", with);
  result("without", without);
  result("with", with);

  if (!expect_near(largest_error(model, line, true, 0.1, 1), 0, 1,
                   "on a line at constant speed, the hands are in time",
                   "at constant speed, k r = -b v"))
    return 0;
  if (!expect_near(with, 0, 1.5, "on a circle, the hands are in time",
                   "on a circle the velocity turns: the weld must also "
                   "provide the acceleration"))
    return 0;
  expect_near(largest_error(model, circle, true, 0.05, 0.7), 0, 1.5,
              "with another damping ratio, the hands are in time",
              "k has the ratio squared, b does not have it");
}
