// Lesson 1.6: which push makes a crate slide, in each direction?
//
// INPUT    push_crate.xml: 1 kg, mu = 0.5
// PROCESS  for both friction cones and 24 directions, find by bisection the
//          smallest push that makes the crate run
// OUTPUT   that push along x and halfway between x and y; for the lesson, all
//          directions as the table "cone"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_6_cone

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::Vector2d;

// #region slides
// Does it run, 0.3 s after the push began? Creep is far slower than 1 cm/s.
bool slides(const Model& model, const Data& data, const Data& resting,
            const Vector2d& push) {
  mj_copyData(data, model, resting);
  ctrl(model, data) = push;  // N, along x and y
  for (int step = 0; step < 150; ++step) mj_step(model, data);
  return qvel(model, data).head<2>().norm() > 0.01;
}

// The smallest push in a direction that makes it run, to 2 mN.
double threshold(const Model& model, const Data& data, const Data& resting,
                 const Vector2d& direction) {
  double low = 2, high = 6;  // N
  while (high - low > 0.002) {
    const double middle = (low + high) / 2;
    const bool runs = slides(model, data, resting, middle * direction);
    (runs ? high : low) = middle;
  }
  return high;
}
// #endregion

int main() {
  const Model model = load_model("push_crate");
  const double limit = model->geom_friction[0] * 9.81;  // mu m g
  std::vector<double> cones, angles, x, y, theory_x, theory_y;

  std::printf("cone        along x (N)  at 45 degrees (N)\n");
  for (const int cone : {mjCONE_ELLIPTIC, mjCONE_PYRAMIDAL}) {
    model->opt.cone = cone;
    const Data data = make_data(model), resting = make_data(model);
    for (int step = 0; step < 500; ++step) mj_step(model, resting);

    const bool elliptic = cone == mjCONE_ELLIPTIC;
    double along = 0, between = 0, at_30 = 0;
    for (int angle = 0; angle <= 360; angle += 15) {
      const double a = angle * M_PI / 180;
      const Vector2d way(std::cos(a), std::sin(a));
      const double push = threshold(model, data, resting, way);
      const double share = elliptic ? 1 : 1 / way.lpNorm<1>();
      cones.push_back(cone);
      angles.push_back(angle);
      x.push_back(push * way.x() / limit);
      y.push_back(push * way.y() / limit);
      theory_x.push_back(share * way.x());
      theory_y.push_back(share * way.y());
      if (angle == 0) along = push;
      if (angle == 45) between = push;
      if (angle == 30) at_30 = push;
    }
    std::printf("%-9s  %12.2f  %17.2f\n", elliptic ? "elliptic" : "pyramidal",
                along, between);
    result(elliptic ? "elliptic_along" : "pyramidal_along", along);
    result(elliptic ? "elliptic_between" : "pyramidal_between", between);
    if (!elliptic) result("share_30", at_30 / limit);
  }
  table("cone", {{"cone", cones},
                 {"angle", angles},
                 {"x", x},
                 {"y", y},
                 {"theory x", theory_x},
                 {"theory y", theory_y}});
}
