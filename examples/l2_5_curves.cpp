// Lesson 2.5: the curves of a muscle, written out.
//
// INPUT    MuJoCo's default parameters of a muscle, and others
// PROCESS  compute the curves by our formulas, and by mju_muscleGain and
//          mju_muscleBias; switch a muscle on and off
// OUTPUT   some values; whether both agree; how long it takes to switch; for
//          the lesson, the tables "length" and "velocity"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_5_curves

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

// #region curves
struct Muscle {
  double lmin = 0.5, lmax = 1.6, vmax = 1.5, fpmax = 1.3, fvmax = 1.2;

  double FL(double L) const {  // active force, by length
    const double x = (L - 1) / ((L < 1 ? lmin : lmax) - 1);  // 0 to 1
    if (x > 1) return 0;
    return x < 0.5 ? 1 - 2 * x * x : 2 * (1 - x) * (1 - x);
  }
  double FV(double V) const {  // active force, by velocity
    const double u = V / vmax, y = fvmax - 1;
    if (u < -1) return 0;
    if (u <= 0) return (1 + u) * (1 + u);
    return u < y ? fvmax - (y - u) * (y - u) / y : fvmax;
  }
  double FP(double L) const {  // passive force
    const double x = (L - 1) / (lmax - 1);
    if (x <= 0) return 0;
    return fpmax * (x < 0.5 ? 2 * x * x : 2 * x - 0.5);
  }
};
// #endregion

// Lengths are in units of L0, and forces in units of the peak force.
double gain(const Muscle& m, double L, double V) {
  const double range[] = {0.75, 1.05}, force = 1, scale = 200;
  const double parameters[] = {range[0], range[1], force,   scale,  m.lmin,
                               m.lmax,   m.vmax,   m.fpmax, m.fvmax};
  return mju_muscleGain(L, V, range, 1, parameters);
}
double bias(const Muscle& m, double L) {
  const double range[] = {0.75, 1.05}, force = 1, scale = 200;
  const double parameters[] = {range[0], range[1], force,   scale,  m.lmin,
                               m.lmax,   m.vmax,   m.fpmax, m.fvmax};
  return mju_muscleBias(L, range, 1, parameters);
}

// How long the activation takes to get from `from` to `to`, in ms.
double takes(double ctrl, double from, double to) {
  const double constants[] = {0.01, 0.04}, step = 1e-6;
  double act = from, time = 0;
  while ((to - act) * (to - from) > 0) {
    act += step * mju_muscleDynamics(ctrl, act, constants);
    time += step;
  }
  return 1000 * time;
}

int main() {
  double apart = 0;
  const Muscle usual, other{0.6, 1.4, 8, 0.9, 1.5};
  for (const Muscle& m : {usual, other})
    for (double L = m.lmin; L < 2; L += 0.0137)
      for (double V = -10; V < 10; V += 0.137)
        apart = std::max({apart, std::abs(m.FL(L) * m.FV(V) + gain(m, L, V)),
                          std::abs(m.FP(L) + bias(m, L))});
  std::printf("formulas and MuJoCo, within 1e-12: %s\n",
              apart < 1e-12 ? "yes" : "no");

  std::vector<double> lengths, FL, FP, speeds, FV;
  for (double L = 0.5; L < 1.605; L += 0.02) {
    lengths.push_back(L);
    FL.push_back(usual.FL(L));
    FP.push_back(usual.FP(L));
  }
  for (double V = -1.8; V < 0.905; V += 0.05) {
    speeds.push_back(V);
    FV.push_back(usual.FV(V));
  }
  table("length", {{"L", lengths}, {"FL", FL}, {"FP", FP}});
  table("velocity", {{"V", speeds}, {"FV", FV}});
  result("FP_at_lmax", -bias(usual, usual.lmax));

  // On: dt = tau (0.5 + 1.5 a) / (1 - a) da. Off: dt = tau / (0.5 + 1.5 a) / a.
  const double on = 10 * (-1.5 * 0.9 - 2 * std::log(1 - 0.9));
  const double off = 40 * 2 * (std::log(2.0) - std::log(0.65 / 0.1));
  std::printf("on, from 0 to 0.9:  %5.1f ms, formula %5.1f ms\n",
              takes(1, 0, 0.9), on);
  std::printf("off, from 1 to 0.1: %5.1f ms, formula %5.1f ms\n",
              takes(0, 1, 0.1), -off);
  result("on", on);
  result("off", -off);
}
