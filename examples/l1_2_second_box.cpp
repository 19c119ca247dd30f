// Lesson 1.2, exercise: a second free box, and where it moves everything else.
//
// INPUT    joint_zoo.xml, and one more free box put into its text
// PROCESS  predict by hand nq, nv and every joint's address in qpos and in
//          qvel, then compile the edited model and ask it
// OUTPUT   prediction and compiled model side by side; exits with 1 where they
//          differ
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_2_second_box

#include <cstdio>
#include <fstream>
#include <iterator>
#include <mjcourse/mjcourse.hpp>
#include <stdexcept>
#include <string>

using namespace mjcourse;

constexpr const char* kSecondBox = R"(
    <body name="second_box" pos="-0.66 0 0.75">
      <freejoint name="second"/>
      <geom type="box" size="0.1 0.06 0.04" mass="1" material="free"/>
    </body>
)";

// The prediction: the joints keep their order, each begins where the one before
// it ends, and whatever follows the new box has moved by 7 in qpos and by 6 in
// qvel.
struct Address {
  const char* joint;
  int qpos, qvel;
};
constexpr Address kPredicted[] = {
    {"free", 0, 0},     // still first
    {"second", 7, 6},   // after the first box's 7 and 6 numbers
    {"ball", 14, 12},   // was 7, 6
    {"slide", 18, 15},  // was 11, 9
    {"hinge", 19, 16},  // was 12, 10
};
constexpr int kPredictedNq = 13 + 7, kPredictedNv = 11 + 6;

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

int main() {
  const Model model = load_zoo_with_second_box();
  bool agree = model->nq == kPredictedNq && model->nv == kPredictedNv;

  std::printf("          predicted      compiled\n");
  std::printf("sizes     nq %2d nv %2d    nq %2d nv %2d\n", kPredictedNq,
              kPredictedNv, model->nq, model->nv);
  std::printf("joint     qpos  qvel     qpos  qvel\n");
  for (const auto& [name, qadr, vadr] : kPredicted) {
    const int joint = id_of(model, mjOBJ_JOINT, name);
    const int compiled_qadr = model->jnt_qposadr[joint];
    const int compiled_vadr = model->jnt_dofadr[joint];
    std::printf("%-9s %4d  %4d     %4d  %4d\n", name, qadr, vadr, compiled_qadr,
                compiled_vadr);
    agree = agree && qadr == compiled_qadr && vadr == compiled_vadr;
  }

  // For the lesson's text to quote.
  const Model zoo = load_model("joint_zoo");
  const int hinge = id_of(model, mjOBJ_JOINT, "hinge");
  const int before = id_of(zoo, mjOBJ_JOINT, "hinge");
  result("nq", model->nq);
  result("nv", model->nv);
  result("qpos_shift", model->jnt_qposadr[hinge] - zoo->jnt_qposadr[before]);
  result("qvel_shift", model->jnt_dofadr[hinge] - zoo->jnt_dofadr[before]);

  std::printf("prediction and model agree: %s\n", agree ? "yes" : "no");
  return agree ? 0 : 1;
}
