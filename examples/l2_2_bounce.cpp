// Lesson 2.2, exercise: a floor off which a ball bounces as it is told.
//
// INPUT    soft_floor.xml, its impedance the same at any depth; the ball of 1 kg
// PROCESS  throw it at the floor with 2 m/s; measure the speed with which it
//          leaves, and how long it touched
// OUTPUT   the stiffness and damping for one coefficient of restitution, and
//          what was measured with them; checks others; for the lesson, many
//          damping ratios as the table "bounce"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_2_bounce

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

struct Solref {
  double first, second;
};

// e = exp(-2 z acos(z) / sqrt(1 - z^2)), for a damping ratio z below 1.
double restitution(double z) {
  return std::exp(-2 * z * std::acos(z) / std::sqrt(1 - z * z));
}

// The damping ratio with which a ball keeps the share e of its speed.
double damping_ratio(double e) {
  double low = 0, high = 0.9999;  // a larger ratio keeps less
  for (int halving = 0; halving < 60; ++halving) {
    const double z = (low + high) / 2;
    (restitution(z) > e ? low : high) = z;
  }
  return low;
}

// solref, in its negative form, with which a ball keeps the share e of its
// speed, and touches for `seconds`.
Solref solref_for(double e, double seconds) {
  // #region answer
  const double z = damping_ratio(e);
  const double omega = 2 * std::acos(z) / (std::sqrt(1 - z * z) * seconds);
  return {-omega * omega, -2 * z * omega};
  // #starter
  // return {-1000, 0};  // an elastic floor
  // #wrong half-a-period: it touches for as long
  // const double z = damping_ratio(e);
  // const double omega = M_PI / (std::sqrt(1 - z * z) * seconds);
  // return {-omega * omega, -2 * z * omega};
  // #wrong undamped-frequency: it touches for as long
  // const double z = damping_ratio(e);
  // const double omega = 2 * std::acos(z) / seconds;
  // return {-omega * omega, -2 * z * omega};
  // #wrong forgets-the-two: it leaves as fast
  // const double z = damping_ratio(e);
  // const double omega = 2 * std::acos(z) / (std::sqrt(1 - z * z) * seconds);
  // return {-omega * omega, -z * omega};
  // #wrong divides-by-dmax: it leaves as fast
  // const double z = damping_ratio(e), d = 0.95;
  // const double omega = 2 * std::acos(z) / (std::sqrt(1 - z * z) * seconds);
  // return {-omega * omega / (d * d), -2 * z * omega / (d * d * d)};
  // #wrong forgets-a-minus: both numbers are negative
  // const double z = damping_ratio(e);
  // const double omega = 2 * std::acos(z) / (std::sqrt(1 - z * z) * seconds);
  // return {-omega * omega, 2 * z * omega};
  // #endregion
}

struct Bounce {
  double kept = 0, seconds = 0;  // share of the speed; of the contact
};

// Thrown at 2 m/s. It has a tenth of a second to leave again.
Bounce bounce(const Model& model, const Solref& solref, double dmax = 0.95) {
  const int floor = id_of(model, mjOBJ_GEOM, "floor");
  model->geom_solref[mjNREF * floor] = solref.first;
  model->geom_solref[mjNREF * floor + 1] = solref.second;
  model->geom_solimp[mjNIMP * floor] = dmax;
  model->geom_solimp[mjNIMP * floor + 1] = dmax;
  const int ball = id_of(model, mjOBJ_GEOM, "middle");
  const Data data = make_data(model);
  const int z = 9, vz = 8;  // the second ball's, in qpos and in qvel
  data->qpos[z] = 0.0501;
  data->qvel[vz] = -2;
  Bounce found;
  while (data->time < 0.15) {
    mj_step(model, data);
    bool pushes = false;
    for (int i = 0; i < data->ncon; ++i) {
      const int row = data->contact[i].efc_address;
      if (data->contact[i].geom2 == ball && row >= 0)
        pushes = data->efc_force[row] > 0;
    }
    if (pushes) found.seconds += model->opt.timestep;
    if (!pushes && found.seconds > 0) {
      found.kept = data->qvel[vz] / 2;
      break;
    }
  }
  return found;
}

int main() {
  const Model model = load_model("soft_floor");
  model->opt.timestep = 5e-5;
  const double gravity = model->opt.gravity[2];
  std::vector<double> ratio, formula, thrown, dropped;
  for (double z = 0.02; z < 0.99; z += 0.06) {
    const Solref solref{0.02, z};
    model->opt.gravity[2] = 0;
    ratio.push_back(z);
    formula.push_back(restitution(z));
    thrown.push_back(bounce(model, solref).kept);
    model->opt.gravity[2] = gravity;
    dropped.push_back(bounce(model, solref).kept);
  }
  table("bounce", {{"ratio", ratio},
                   {"formula", formula},
                   {"thrown", thrown},
                   {"dropped", dropped}});

  model->opt.gravity[2] = 0;
  const Solref wanted = solref_for(0.7, 0.01);
  if (!expect(wanted.first < 0 && wanted.second <= 0,
              "both numbers are negative",
              "of one positive and one negative number MuJoCo makes 0.02 and "
              "1, with a warning"))
    return 0;
  const Bounce found = bounce(model, wanted);
  std::printf("solref %.0f %.1f: keeps %.3f, touches for %.2f ms\n",
              wanted.first, wanted.second, found.kept, 1000 * found.seconds);

  for (const double e : {0.9, 0.6, 0.3}) {
    for (const double seconds : {0.01, 0.02}) {
      for (const double dmax : {0.95, 0.7}) {
        const Bounce b = bounce(model, solref_for(e, seconds), dmax);
        if (!expect_near(b.kept, e, 0.01, "it leaves as fast as was asked",
                         "with d = dmax the two numbers are minus the square "
                         "of omega and minus 2 z omega, whatever dmax is"))
          return 0;
        if (!expect_near(b.seconds, seconds, 0.02 * seconds,
                         "it touches for as long as was asked",
                         "the contact ends with its force, at the phase "
                         "2 acos(z) of the damped oscillation"))
          return 0;
      }
    }
  }
}
