// Lesson 2.4: an arm whose hand follows a mocap body.
//
// INPUT    pick_place.xml; a mocap body and a weld to its hand, written into
//          its text
// PROCESS  put the target onto the hand, then move it by 20 cm in a second,
//          while the servos hold their angles, and while they follow
// OUTPUT   how far the hand is from the target, and the force in the weld
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_4_drag

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;

// #region insert
// pick_place.xml with a mocap body, welded to the arm's hand.
Model with_target(const std::string& relpose) {
  std::ifstream file(models_directory() / "pick_place.xml");
  std::string text(std::istreambuf_iterator<char>(file), {});
  const auto insert = [&](const std::string& end, const std::string& what) {
    text.insert(text.find(end), what);
  };
  insert("</worldbody>", "<body name='target' mocap='true'/>");
  insert("</equality>",
         "<weld name='drag' body1='hand' body2='target' " + relpose + "/>");
  return load_model_xml(text);
}

// Where the rows of an equality begin; -1 if it is switched off.
int first_row(const mjData* data, int equality) {
  for (int i = 0; i < data->ne; ++i)
    if (data->efc_id[i] == equality) return i;
  return -1;
}
// #endregion

struct Dragged {
  double start = 0, on_the_way = 0, end = 0, force = 0;
};

Dragged drag(const Model& model, bool servos_follow) {
  const Data data = make_data(model);
  const int hand = id_of(model, mjOBJ_BODY, "hand");
  const int weld = id_of(model, mjOBJ_EQUALITY, "drag");
  // #region drag
  mj_resetDataKeyframe(model, data, id_of(model, mjOBJ_KEY, "home"));
  mj_forward(model, data);
  mju_copy3(data->mocap_pos, data->xpos + 3 * hand);
  mju_copy4(data->mocap_quat, data->xquat + 4 * hand);
  const double y = data->mocap_pos[1];
  mj_forward(model, data);
  const int row = first_row(data, weld);
  const auto away = [&] { return 1000 * mju_norm3(data->efc_pos + row); };

  Dragged found{.start = away()};
  for (; data->time < 3; mj_step(model, data)) {
    data->mocap_pos[1] = y + 0.2 * std::min(data->time, 1.0);  // m
    if (servos_follow) mju_copy(data->ctrl, data->qpos, 7);
    if (data->time < 0.9) found.on_the_way = away();
  }
  found.end = away();
  found.force = mju_norm3(data->efc_force + row);
  // #endregion
  return found;
}

int main() {
  const char* const same_pose = "relpose='0 0 0 1 0 0 0'";
  const Model model = with_target(same_pose);
  const int hand = id_of(model, mjOBJ_BODY, "hand");
  result("acts_as", 1 / model->body_invweight0[2 * hand]);
  const double speed = 0.2;  // m/s
  result("expected_way", 1000 * 2 * model->eq_solref[mjNREF] * speed);

  std::printf("servos  on the way (mm)  at the end (mm)  weld (N)\n");
  for (const bool follow : {false, true}) {
    const Dragged found = drag(model, follow);
    std::printf("%-6s  %15.1f  %15.1f  %8.0f\n", follow ? "follow" : "hold",
                found.on_the_way, found.end, found.force);
    result(follow ? "following" : "holding", found.end);
    result(follow ? "following_way" : "holding_way", found.on_the_way);
    result(follow ? "following_force" : "holding_force", found.force);
  }
  const Dragged wrong = drag(with_target(""), true);
  std::printf("without relpose, the weld starts %.0f mm away\n", wrong.start);
  result("wrong_start", wrong.start);
}
