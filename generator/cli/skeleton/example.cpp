// @name@: @model@.xml moves for one second.
//
// INPUT    @model@.xml, as its first keyframe sets it, if it has one
// PROCESS  steps of MuJoCo until a second has passed
// OUTPUT   the positions at the end (qpos); the first of them as a result that the lesson can quote
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
  if (model->nq > 0) result("first", data->qpos[0]);  // in the lesson: {@name@} first
}
