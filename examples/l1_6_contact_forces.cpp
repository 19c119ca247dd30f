// Lesson 1.6: what is in data.contact, and what the floor does to a crate.
//
// INPUT    push_crate.xml: a crate of 1 kg on four corners, pushed with 2 N
// PROCESS  simulate a second; for each contact, ask MuJoCo for the force in the
//          contact's frame, turn it into the world's, add it up
// OUTPUT   the contacts, and the sum of their forces on the crate; for a question
//          of the lesson, the sum of the normal forces when 6 N press as well
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_6_contact_forces

#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;
// Row by row: the normal, then the two tangents.
using Frame = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

int main() {
  const Model model = load_model("push_crate");
  const Data data = make_data(model);
  ctrl(model, data)[0] = 2;  // N, along x
  for (int step = 0; step < 500; ++step) mj_step(model, data);
  mj_forward(model, data);

  std::printf("geoms          dist (mm)  normal  tangent 1  tangent 2 (N)\n");
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < data->ncon; ++i) {
    const mjContact& contact = data->contact[i];
    Vector6d force;  // and torque, which is 0 for condim 3
    mj_contactForce(model, data, i, force.data());
    std::printf("%s, %s  %9.3f  %6.3f  %9.3f  %9.3f\n",
                mj_id2name(model, mjOBJ_GEOM, contact.geom1),
                mj_id2name(model, mjOBJ_GEOM, contact.geom2),
                1000 * contact.dist, force[0], force[1], force[2]);
    sum += Frame(contact.frame).transpose() * force.head<3>();
  }
  print("first contact, normal    =", Vector3d(data->contact[0].frame));
  print("first contact, tangent 1 =", Vector3d(data->contact[0].frame + 3));
  print("sum, in the world (N)    =", sum);

  result("weight", sum.z());
  result("friction", -sum.x());

  const int crate = id_of(model, mjOBJ_BODY, "crate");
  data->xfrc_applied[6 * crate + 2] = -6;  // N, downwards
  for (int step = 0; step < 500; ++step) mj_step(model, data);
  mj_forward(model, data);
  double pressed = 0;
  for (int i = 0; i < data->ncon; ++i) {
    Vector6d force;
    mj_contactForce(model, data, i, force.data());
    pressed += force[0];
  }
  result("pressed", pressed);
}
