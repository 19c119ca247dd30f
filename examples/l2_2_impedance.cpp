// Lesson 2.2: what each of the five numbers of solimp does.
//
// INPUT    soft_floor.xml: a ball of 1 kg; MuJoCo's default solimp, and five
//          others in which one number differs
// PROCESS  let the ball come to rest, alone and under a load of ten times its
//          weight; then put it at many depths, and read d
// OUTPUT   depths and d at rest; for the lesson, four shapes as the table
//          "shapes"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_2_impedance

#include <array>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <utility>
#include <vector>

using namespace mjcourse;
// dmin, dmax, width (m), midpoint, power
using Solimp = std::array<double, 5>;

void set(const Model& model, const Solimp& solimp) {
  const int floor = id_of(model, mjOBJ_GEOM, "floor");
  mju_copy(model->geom_solimp + mjNIMP * floor, solimp.data(), mjNIMP);
}

// The ball's contact is the second of three, and its first row the normal's.
constexpr int kBall = 1;
double impedance(const mjData* data) {
  return data->efc_KBIP[4 * data->contact[kBall].efc_address + 2];
}

std::pair<double, double> rest(const Model& model, double load) {
  const Data data = make_data(model);
  ctrl(model, data)[kBall] = load;
  while (data->time < 2) mj_step(model, data);
  mj_forward(model, data);
  return {-1000 * data->contact[kBall].dist, impedance(data)};
}

int main() {
  const Model model = load_model("soft_floor");
  const Solimp usual{0.9, 0.95, 0.001, 0.5, 2};
  // #region cases
  struct Case {
    const char* name;
    int which;  // of the five
    double value;
  };
  std::printf("                  alone         ten times the load\n");
  std::printf("changed       depth (mm)     d  depth (mm)     d\n");
  for (const auto& [name, which, value] :
       {Case{"nothing", 0, 0.9}, Case{"dmin 0.5", 0, 0.5},
        Case{"dmax 0.99", 1, 0.99}, Case{"width 5 mm", 2, 0.005},
        Case{"midpoint 0.1", 3, 0.1}, Case{"power 6", 4, 6}}) {
    Solimp solimp = usual;
    solimp[which] = value;
    set(model, solimp);
    const auto [depth, d] = rest(model, 0);
    const auto [loaded, d_loaded] = rest(model, 9 * 9.81);
    std::printf("%-12s  %10.3f %.3f  %10.3f %.3f\n", name, depth, d, loaded,
                d_loaded);
  }
  // #endregion

  std::vector<double> shape, over, d;
  const Solimp shapes[] = {{0, 1, 0.005, 0.5, 2},
                           {0, 1, 0.005, 0.2, 2},
                           {0, 1, 0.005, 0.5, 6},
                           {0, 1, 0.005, 0.5, 1}};
  const Data data = make_data(model);
  for (int which = 0; which < 4; ++which) {
    set(model, shapes[which]);
    for (int percent = 1; percent <= 120; ++percent) {
      data->qpos[7 * kBall + 2] = 0.05 - 0.005 * percent / 100;
      mj_forward(model, data);
      shape.push_back(which);
      over.push_back(percent / 100.0);
      d.push_back(impedance(data));
    }
  }
  table("shapes", {{"shape", shape}, {"depth", over}, {"d", d}});
}
