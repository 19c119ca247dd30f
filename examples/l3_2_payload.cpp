// Lesson 3.2, challenge: weigh a load with a wrist that has never been tared.
//
// INPUT    a load on a wrist with a force, a torque and an acceleration sensor
// PROCESS  hold it in 40 poses; read the sensors, with noise and an offset;
//          solve for mass and centre of mass by least squares
// OUTPUT   what was found of three loads; checks it against the models
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_2_payload

#include <cstdio>
#include <mjcourse/imu.hpp>
#include <string>

using namespace mjcourse;
using Eigen::Map, Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Vector3d,
    Eigen::Vector4d, Eigen::VectorXd;

struct Load {
  double mass = 0;                     // kg
  Vector3d centre = Vector3d::Zero();  // m, from the wrist, in its frame
};

// The matrix of the cross product: skew(a) * b is a x b.
Matrix3d skew(const Vector3d& a) {
  Matrix3d matrix;
  matrix << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return matrix;
}

// A column for each pose: what the force sensor, the torque sensor and the
// accelerometer read, all in the frame of one site. Force and torque have an
// unknown offset, the same in all poses.
Load identify(const MatrixXd& force, const MatrixXd& torque,
              const MatrixXd& acc) {
  // #region answer
  const Eigen::Index n = acc.cols();
  MatrixXd A(3 * n, 4), B(3 * n, 6);  // m and offset; m c and offset
  for (Eigen::Index i = 0; i < n; ++i) {
    A.middleRows(3 * i, 3) << acc.col(i), Matrix3d::Identity();
    B.middleRows(3 * i, 3) << -skew(acc.col(i)), Matrix3d::Identity();
  }
  const VectorXd f = A.colPivHouseholderQr().solve(force.reshaped());
  const VectorXd t = B.colPivHouseholderQr().solve(torque.reshaped());
  return {f[0], t.head<3>() / f[0]};
  // #starter
  // Load load;
  // load.mass = force.col(0).norm() / 9.81;  // in one pose, without an offset
  // return load;
  // #wrong forgets-the-offset: the mass is found
  // const double m = force.cwiseProduct(acc).sum() / acc.squaredNorm();
  // Load load;
  // load.mass = m;
  // return load;
  // #wrong takes-the-wrong-sign: the mass is found
  // const MatrixXd pull = -force;
  // const Vector3d mean = acc.rowwise().mean(), off = pull.rowwise().mean();
  // const MatrixXd f = acc.colwise() - mean;
  // Load load;
  // load.mass = (pull.colwise() - off).cwiseProduct(f).sum() / f.squaredNorm();
  // return load;
  // #wrong forgets-to-divide: the centre is found
  // const Eigen::Index n = acc.cols();
  // MatrixXd A(3 * n, 4), B(3 * n, 6);
  // for (Eigen::Index i = 0; i < n; ++i) {
  //   A.middleRows(3 * i, 3) << acc.col(i), Matrix3d::Identity();
  //   B.middleRows(3 * i, 3) << -skew(acc.col(i)), Matrix3d::Identity();
  // }
  // const VectorXd f = A.colPivHouseholderQr().solve(force.reshaped());
  // const VectorXd t = B.colPivHouseholderQr().solve(torque.reshaped());
  // return {f[0], t.head<3>()};
  // #wrong turns-the-cross-product: the centre is found
  // const Eigen::Index n = acc.cols();
  // MatrixXd A(3 * n, 4), B(3 * n, 6);
  // for (Eigen::Index i = 0; i < n; ++i) {
  //   A.middleRows(3 * i, 3) << acc.col(i), Matrix3d::Identity();
  //   B.middleRows(3 * i, 3) << skew(acc.col(i)), Matrix3d::Identity();
  // }
  // const VectorXd f = A.colPivHouseholderQr().solve(force.reshaped());
  // const VectorXd t = B.colPivHouseholderQr().solve(torque.reshaped());
  // return {f[0], t.head<3>() / f[0]};
  // #endregion
}

// A hand that is placed by a program, and a load welded to it.
Model hand(double mass, const Vector3d& centre) {
  const auto text = [](double x) { return std::to_string(x); };
  return load_model_xml(R"(
    <mujoco>
      <worldbody><body mocap="true">
        <body>
          <site name="wrist"/>
          <inertial pos=")" +
                        text(centre[0]) + " " + text(centre[1]) + " " +
                        text(centre[2]) + R"(" mass=")" + text(mass) + R"("
                    diaginertia="0.001 0.001 0.001"/>
        </body>
      </body></worldbody>
      <sensor>
        <force site="wrist"/> <torque site="wrist"/>
        <accelerometer site="wrist"/>
      </sensor>
    </mujoco>)");
}

int main() {
  Gaussian gauss(5);
  const auto noise = [&](double size) {
    Vector3d random;
    for (double& x : random) x = size * gauss();
    return random;
  };
  std::printf("mass (kg)  found   centre (mm)          found\n");
  for (const auto& [mass, centre] :
       {Load{0.3, {0, 0, 0.08}}, Load{1.2, {0.03, -0.02, 0.05}},
        Load{2.5, {-0.05, 0.01, 0.12}}}) {
    const Model model = hand(mass, centre);
    const Data data = make_data(model);
    constexpr int poses = 40;
    MatrixXd force(3, poses), torque(3, poses), acc(3, poses);
    for (int i = 0; i < poses; ++i) {
      Vector4d quat;
      for (double& x : quat) x = gauss();  // any rotation
      Map<Vector4d>(data->mocap_quat) = quat.normalized();
      mj_forward(model, data);
      force.col(i) = Vector3d(data->sensordata) + noise(0.05);
      torque.col(i) = Vector3d(data->sensordata + 3) + noise(0.005);
      acc.col(i) = Vector3d(data->sensordata + 6) + noise(0.02);
    }
    force.colwise() += Vector3d(4, -2, 7);  // N: what a strain gauge drifts
    torque.colwise() += Vector3d(0.1, 0.2, -0.1);  // N m
    const Load found = identify(force, torque, acc);
    std::printf("%9.1f  %5.2f   %-18s   %s\n", mass, found.mass,
                to_text(1000 * centre, 1).c_str(),
                to_text(1000 * found.centre, 1).c_str());
    if (!expect_near(found.mass, mass, 0.01, "the mass is found",
                     "force is mass times specific force, plus an offset: "
                     "four unknowns, the same in all poses"))
      continue;
    expect_near(found.centre, centre, 0.005, "the centre is found",
                "the torque is c x (m f), plus an offset: linear in m c");
  }
}
