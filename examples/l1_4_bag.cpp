// Lesson 1.4, exercise: a pull at the hand instead of the centre of mass.
//
// INPUT    three_arms.xml at rest, and 5 N straight down at the middle arm's hand
// PROCESS  bring the pull in four ways: mj_jacSite by hand, mj_applyFT, and
//          xfrc_applied without and with the torque that moves it to the hand
// OUTPUT   the middle arm's accelerations; exits with 1 where the three right
//          ways do not agree within 1e-10
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_4_bag

#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::Map, Eigen::Vector2d, Eigen::Vector3d;
using RowMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

int main() {
  const Model model = load_model("three_arms");
  const int body = id_of(model, mjOBJ_BODY, "middle_fore");
  const int hand = id_of(model, mjOBJ_SITE, "middle_hand");
  const Vector3d force(0, 0, -5);  // N

  // Fresh data, one way of pulling, and the two resulting accelerations.
  const auto try_way = [&](const char* name, const auto& pull) -> Vector2d {
    const Data data = make_data(model);
    mj_forward(model, data);
    pull(data, Vector3d(Map<const Vector3d>(data->site_xpos + 3 * hand)));
    mj_forward(model, data);
    const Vector2d acceleration = qacc(model, data).segment<2>(2);
    print(name, acceleration);
    return acceleration;
  };

  const Vector2d jacobian = try_way(
      "J'F into qfrc_applied    ", [&](const Data& data, const Vector3d&) {
        RowMatrix at_hand(3, model->nv);
        mj_jacSite(model, data, at_hand.data(), nullptr, hand);
        VectorView(data->qfrc_applied, model->nv) = at_hand.transpose() * force;
      });
  const Vector2d apply_ft =
      try_way("mj_applyFT               ",
              [&](const Data& data, const Vector3d& point) {
                const Vector3d none(0, 0, 0);
                mj_applyFT(model, data, force.data(), none.data(), point.data(),
                           body, data->qfrc_applied);
              });
  const Vector2d torque =
      try_way("xfrc_applied, with torque",
              [&](const Data& data, const Vector3d& point) {
                const Map<const Vector3d> centre(data->xipos + 3 * body);
                Map<Vector3d>(data->xfrc_applied + 6 * body) = force;
                Map<Vector3d>(data->xfrc_applied + 6 * body + 3) =
                    (point - centre).cross(force);
              });
  try_way("xfrc_applied, force alone", [&](const Data& data, const Vector3d&) {
    Map<Vector3d>(data->xfrc_applied + 6 * body) = force;
  });
  return jacobian.isApprox(apply_ft, 1e-10) && jacobian.isApprox(torque, 1e-10)
             ? 0
             : 1;
}
