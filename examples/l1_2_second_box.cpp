// Lesson 1.2, exercise: a second free box, and where it moves everything else.
//
// INPUT    joint_zoo.xml, and one more free box put into its text
// PROCESS  predict nq, nv and every joint's address in qpos and in qvel from
//          the types of the joints, then compile the edited model and ask it
// OUTPUT   prediction and compiled model side by side; checks that they agree,
//          and that they do for other models
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_2_second_box

#include <cstdio>
#include <fstream>
#include <iterator>
#include <mjcourse/mjcourse.hpp>
#include <stdexcept>
#include <string>
#include <vector>

using namespace mjcourse;

constexpr const char* kSecondBox = R"(
    <body name="second_box" pos="-0.66 0 0.75">
      <freejoint name="second"/>
      <geom type="box" size="0.1 0.06 0.04" mass="1" material="free"/>
    </body>
)";

struct Address {
  int qpos, qvel;  // where a joint's numbers begin
  bool operator==(const Address&) const = default;
};
struct Layout {
  std::vector<Address> joints;
  int nq, nv;
  bool operator==(const Layout&) const = default;
};

// Where the joints of a model begin, in their order, and how many numbers there
// are in all. `types` has the joints' types in the same order: mjJNT_FREE,
// mjJNT_BALL, mjJNT_SLIDE or mjJNT_HINGE.
Layout predict(const std::vector<int>& types) {
  // #region answer
  Layout all{{}, 0, 0};
  for (const int type : types) {
    all.joints.push_back({all.nq, all.nv});  // where the one before it ends
    all.nq += type == mjJNT_FREE ? 7 : type == mjJNT_BALL ? 4 : 1;
    all.nv += type == mjJNT_FREE ? 6 : type == mjJNT_BALL ? 3 : 1;
  }
  return all;
  // #starter
  // // How many numbers does each type add to qpos, and how many to qvel?
  // return {{}, 0, 0};
  // #wrong three-angles: each joint begins at its place in qpos
  // Layout all{{}, 0, 0};
  // for (const int type : types) {
  //   all.joints.push_back({all.nq, all.nv});
  //   all.nq += type == mjJNT_FREE ? 6 : type == mjJNT_BALL ? 3 : 1;
  //   all.nv = all.nq;
  // }
  // return all;
  // #wrong as-many-in-qvel: each joint begins at its place in qvel
  // Layout all{{}, 0, 0};
  // for (const int type : types) {
  //   all.joints.push_back({all.nq, all.nv});
  //   all.nq += type == mjJNT_FREE ? 7 : type == mjJNT_BALL ? 4 : 1;
  //   all.nv = all.nq;
  // }
  // return all;
  // #wrong last-address: nq and nv are the numbers of all joints
  // std::vector<Address> all;
  // int q = 0, v = 0;
  // for (const int type : types) {
  //   all.push_back({q, v});
  //   q += type == mjJNT_FREE ? 7 : type == mjJNT_BALL ? 4 : 1;
  //   v += type == mjJNT_FREE ? 6 : type == mjJNT_BALL ? 3 : 1;
  // }
  // return {all, all.back().qpos, all.back().qvel};
  // #wrong this-zoo-only: the same rule holds for other models
  // return {{{0, 0}, {7, 6}, {14, 12}, {18, 15}, {19, 16}}, 20, 17};
  // #endregion
}

// joint_zoo.xml with the second box behind the body of the first.
Model load_zoo_with_second_box() {
  std::ifstream file(models_directory() / "joint_zoo.xml");
  std::string mjcf{std::istreambuf_iterator<char>(file), {}};
  const std::string end_tag = "</body>";
  const std::size_t end = mjcf.find(end_tag, mjcf.find("name=\"free_box\""));
  if (end == std::string::npos)
    throw std::runtime_error("joint_zoo.xml has no free_box");
  mjcf.insert(end + end_tag.size(), kSecondBox);
  return load_model_xml(mjcf);
}

Layout compiled(const Model& model) {
  Layout all{{}, model->nq, model->nv};
  for (int joint = 0; joint < model->njnt; ++joint)
    all.joints.push_back({model->jnt_qposadr[joint], model->jnt_dofadr[joint]});
  return all;
}

int main() {
  const char* names[] = {"free", "second", "ball", "slide", "hinge"};
  const Layout predicted =
      predict({mjJNT_FREE, mjJNT_FREE, mjJNT_BALL, mjJNT_SLIDE, mjJNT_HINGE});
  const Model model = load_zoo_with_second_box();
  if (!expect(predicted.joints.size() == std::size(names),
              "each joint has an address",
              "there is one for each of the types, in their order"))
    return 0;

  std::printf("          predicted      compiled\n");
  std::printf("sizes     nq %2d nv %2d    nq %2d nv %2d\n", predicted.nq,
              predicted.nv, model->nq, model->nv);
  std::printf("joint     qpos  qvel     qpos  qvel\n");
  bool is_qpos = true, is_qvel = true;
  for (std::size_t k = 0; k < std::size(names); ++k) {
    const Address mine = predicted.joints[k];
    const int joint = id_of(model, mjOBJ_JOINT, names[k]);
    const int qadr = model->jnt_qposadr[joint], vadr = model->jnt_dofadr[joint];
    std::printf("%-9s %4d  %4d     %4d  %4d\n", names[k], mine.qpos, mine.qvel,
                qadr, vadr);
    is_qpos = is_qpos && mine.qpos == qadr;
    is_qvel = is_qvel && mine.qvel == vadr;
  }

  // For the lesson's text to quote.
  const Model zoo = load_model("joint_zoo");
  const int hinge = id_of(model, mjOBJ_JOINT, "hinge");
  const int before = id_of(zoo, mjOBJ_JOINT, "hinge");
  result("nq", model->nq);
  result("nv", model->nv);
  result("qpos_shift", model->jnt_qposadr[hinge] - zoo->jnt_qposadr[before]);
  result("qvel_shift", model->jnt_dofadr[hinge] - zoo->jnt_dofadr[before]);
  const bool agree = predicted == compiled(model);
  std::printf("prediction and model agree: %s\n", agree ? "yes" : "no");

  if (expect(is_qpos, "each joint begins at its place in qpos",
             "a rotation takes a quaternion there") &&
      expect(is_qvel, "each joint begins at its place in qvel",
             "not every joint has as many velocities as positions") &&
      expect(agree, "nq and nv are the numbers of all joints",
             "the last joint has numbers, too")) {
    for (const char* name : {"joint_zoo", "arm_and_crate", "scales"}) {
      const Model other = load_model(name);
      const int* types = other->jnt_type;
      expect(predict({types, types + other->njnt}) == compiled(other),
             "the same rule holds for other models",
             "numbers of this zoo are still in use");
    }
  }
}
