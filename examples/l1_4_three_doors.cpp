// Lesson 1.4: three doors for a force, one equation behind them.
//
// INPUT    three_arms.xml: three equal arms, one for each door
// PROCESS  push all three alike for a second: the back one by qfrc_applied, the
//          middle one by xfrc_applied, the front one by ctrl; at every step, add
//          up the equation of motion, and ask mj_inverse
// OUTPUT   the terms at the first instant; whether the equation holds, whether
//          mj_inverse finds what came in, whether the arms move as one
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_4_three_doors

#include <algorithm>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;
using Eigen::Vector3d, Eigen::VectorXd;
using RowMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// #region push
// The same push on each arm: its weight upwards, and a little more at the
// forearm. Returns J'xfrc_applied, which MuJoCo adds up but does not keep.
VectorXd push(const Model& model, const Data& data) {
  VectorXd wanted = VectorXd::Zero(model->nv);  // joint by joint
  for (const std::string arm : {"back", "middle", "front"}) {
    for (const std::string link : {"_upper", "_fore"}) {
      const int body = id_of(model, mjOBJ_BODY, (arm + link).c_str());
      Vector3d force = -model->body_mass[body] * Vector3d(model->opt.gravity);
      if (link == "_fore") force += Vector3d(0.5, 0, 1);  // N
      RowMatrix jacobian(3, model->nv);  // of the centre of mass
      mj_jacBodyCom(model, data, jacobian.data(), nullptr, body);
      wanted += jacobian.transpose() * force;
      if (arm == "middle") Vector3d::Map(data->xfrc_applied + 6 * body) = force;
    }
  }
  VectorView(data->qfrc_applied, 2) = wanted.head<2>();
  for (const int motor : {0, 1})
    data->ctrl[motor] = wanted[4 + motor] / model->actuator_gear[6 * motor];

  VectorXd cartesian = VectorXd::Zero(model->nv);
  cartesian.segment<2>(2) = wanted.segment<2>(2);
  return cartesian;
}
// #endregion

int main() {
  const Model model = load_model("three_arms");
  const Data data = make_data(model);
  const auto term = [&](mjtNum* x) { return VectorView(x, model->nv); };
  double unbalanced = 0, not_inverted = 0, apart = 0;
  // #region balance
  for (int step = 0; step < 500; ++step) {
    mj_forward(model, data);  // where the bodies are
    const VectorXd cartesian = push(model, data);
    mj_forward(model, data);  // and what the push does to them

    RowMatrix inertia(model->nv, model->nv);
    mj_fullM(model, inertia.data(), data->qM);
    const VectorXd needed = inertia * qacc(model, data);
    const VectorXd doors =
        term(data->qfrc_applied) + cartesian + term(data->qfrc_actuator);
    const VectorXd sum = term(data->qfrc_passive) + doors +
                         term(data->qfrc_constraint) - term(data->qfrc_bias);
    unbalanced = std::max(unbalanced, (needed - sum).norm());
    mj_inverse(model, data);  // from qacc back to the forces
    const VectorXd missed = term(data->qfrc_inverse) - doors;
    not_inverted = std::max(not_inverted, missed.norm());

    if (step == 0) {
      std::puts("joint            M qacc    bias | applied  J'xfrc  actuator");
      for (int dof = 0; dof < model->nv; ++dof)
        std::printf("%-15s %7.4f %7.4f | %7.4f %7.4f   %7.4f\n",
                    mj_id2name(model, mjOBJ_JOINT, dof), needed[dof],
                    data->qfrc_bias[dof], data->qfrc_applied[dof],
                    cartesian[dof], data->qfrc_actuator[dof]);
    }
    mj_step(model, data);
    const VectorXd q = qpos(model, data);
    apart = std::max({apart, (q.segment<2>(2) - q.head<2>()).norm(),
                      (q.tail<2>() - q.head<2>()).norm()});
  }
  // #endregion
  const auto tiny = [](double x) { return x < 1e-10 ? "yes" : "no"; };
  std::printf("the equation holds within 1e-10:       %s\n", tiny(unbalanced));
  std::printf("mj_inverse finds what the doors added: %s\n",
              tiny(not_inverted));
  std::printf("the arms have moved as one:            %s\n", tiny(apart));
  result("turned", data->qpos[0] - model->qpos0[0]);
}
