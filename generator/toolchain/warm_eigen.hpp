// What programs about MuJoCo mostly do with Eigen, done once.
//
// It stands at the end of a warm header (warm_objects.cpp). That a program uses a template costs
// the compiler more than all else in it; what is used here, it finds made. What is not listed pays
// for it: a name that has more meanings takes longer to look up, 50 ms a program for all of this.
#ifdef EIGEN_CORE_H
namespace mjcourse_warm {

using Eigen::VectorXd;
using State = Eigen::Map<VectorXd>;  // qpos and the like, where MuJoCo has them

template <typename Vector>
double numbers(const Vector& a, const Vector& b) {
  return a.norm() + a.squaredNorm() + a.dot(b) + a.sum() + a.mean() + a.maxCoeff() + a.minCoeff() +
         a.cwiseAbs().maxCoeff() + (a - b).norm() + (a - b).cwiseAbs().maxCoeff();
}

template <typename Vector>
void arithmetic(Vector& a, const Vector& b) {
  Vector c = a + b;
  c = a - b;
  c = (a - b) / 2.0;
  c = a + 2.0 * b;
  c = 2.0 * a;
  c = a * 2.0;
  c = a / 2.0;
  c = -a;
  c += b;
  c -= b;
  c += 2.0 * b;
  c *= 2.0;
  c /= 2.0;
  c = a.cwiseProduct(b);
  a = c.normalized();
}

// A joint's part of a state: 3, 4, 6 and 7 numbers.
template <typename Vector>
void parts(Vector& a, const VectorXd& b, long at) {
  a.template segment<3>(at) << 1, 2, 3;
  a.template segment<4>(at) << 1, 2, 3, 4;
  a.template segment<6>(at) << 1, 2, 3, 4, 5, 6;
  Eigen::Vector3d three = a.template segment<3>(at);
  Eigen::Vector4d four = a.template segment<4>(at);
  a.template segment<3>(at) = three;
  a.template segment<4>(at) = four;
  VectorXd copy = a;
  a = b;
  a.setZero();
  copy = a.template segment<6>(at);
  copy = a.template segment<7>(at);
  copy = a.segment(at, at);
  copy = a.head(at);
  copy = a.tail(at);
}

// A column for each time, a Jacobian, a mass matrix.
inline void matrices(Eigen::MatrixXd& a, VectorXd& b, const State& state) {
  a = Eigen::MatrixXd::Zero(9, 9);
  a.col(0) = state;
  a.col(1) = b;
  b = a.col(0);
  b = a * b;
  a = a.transpose();
  b[0] = a(0, 0) + (a - a).cwiseAbs().maxCoeff() + a.norm();
}

#ifdef EIGEN_GEOMETRY_MODULE_H
// Directions and turns; `at` is where MuJoCo has a place, and a rotation's rows.
inline void turns(Eigen::Vector3d& x, double* at) {
  using Eigen::AngleAxisd, Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;
  using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  x = Vector3d(at) + 2.0 * Vector3d::UnitX();
  x = Vector3d(static_cast<const double*>(at)) + Eigen::Map<const Vector3d>(at);
  const AngleAxisd about_z(1, Vector3d::UnitZ());
  const Quaterniond q = Quaterniond(1, 0, 0, 0) * Quaterniond(about_z);
  x = q.conjugate() * x;
  const Matrix3d r =
      (about_z * AngleAxisd(1, Vector3d::UnitX())).toRotationMatrix() * about_z.matrix();
  x = r * x;
  x = r.transpose() * x;
  x = Eigen::Map<const Rows>(at).transpose() * x;
  x = x.cross(r.col(0));
  x = x.cross(x);
  x[0] = AngleAxisd(q.slerp(0.5, q)).angle() + (r.transpose() * r).trace();
}
#endif

#ifdef EIGEN_CHOLESKY_MODULE_H
// Damped least squares for a hand: six equations for an arm of seven joints, as most have.
inline void equations(Eigen::VectorXd& qpos) {
  using Matrix6d = Eigen::Matrix<double, 6, 6>;
  Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor> all(6, qpos.size());
  const Eigen::Matrix<double, 6, 7> jacobian = all.leftCols<7>();
  const Matrix6d a = jacobian * jacobian.transpose() + 0.1 * 0.1 * Matrix6d::Identity();
  b = a.ldlt().solve(b);
  Eigen::Map<Eigen::Matrix<double, 7, 1>>(qpos.data()) += jacobian.transpose() * a.ldlt().solve(b);
}
#endif

inline void made() {
  VectorXd a = VectorXd::Zero(9), b = VectorXd::Ones(9);
  a = VectorXd::Constant(9, 1.0);
  a = VectorXd::LinSpaced(9, 0.0, 1.0);
  State state(a.data(), 9);
  parts(a, b, 0);
  parts(state, b, 0);
  arithmetic(a, b);
  Eigen::MatrixXd matrix(9, 9);
  matrices(matrix, b, state);
  Eigen::Vector3d x(1, 2, 3), y(4, 5, 6);
  arithmetic(x, y);
  Eigen::Vector2d u(1, 2), v(3, 4);
  arithmetic(u, v);
  const Eigen::Vector4d q(1, 0, 0, 0);
  a[0] = numbers(a, b) + numbers(x, y) + numbers(q, q) + numbers(u, v);
  // As arguments of functions.
  const VectorXd& c = a;
  using Given = Eigen::Ref<const VectorXd>;
  const double sums[] = {
      Given(a).sum(),     Given(state).sum(),           Given(c.segment<3>(0)).sum(),
      Given(x).sum(),     Given(c.segment<4>(0)).sum(), Given(c.segment<6>(0)).sum(),
      Given(q).sum(),     Given(c.segment<7>(0)).sum(), Given(c.segment(0, 2)).sum(),
      Given(a - b).sum(), Given(state - b).sum()};
  a[1] = sums[0];
}

}  // namespace mjcourse_warm
#endif
