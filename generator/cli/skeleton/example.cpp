// @name@: what this program shows, in a sentence.
//
// INPUT    @model@.xml, in its first keyframe where it has one
// PROCESS  one simulated second
// OUTPUT   the pose at the end
//
// Run: cmake -S examples -B build/examples && cmake --build build/examples
//      build/examples/@name@

#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

int main() {
  const Model model = load_model("@model@");
  const Data data = make_data(model);
  if (model->nkey > 0) mj_resetDataKeyframe(model, data, 0);

  const double begin = data->time;
  while (data->time - begin < 1) mj_step(model, data);

  print("qpos after 1 s:", qpos(model, data));
  if (model->nq > 0) result("first", data->qpos[0]);  // for the lesson's text
}
