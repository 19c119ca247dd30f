// Lesson 2.3, challenge: a watch for what a step jumps over.
//
// INPUT    thin_wall.xml: a ball with a radius of 20 mm, a wall 10 mm thick
// PROCESS  throw the ball at several speeds; after each step, cast a ray from
//          where the ball's centre was to where it is
// OUTPUT   how many of 50 throws end behind the wall, in how many no step saw a
//          contact, and in how many the watch spoke
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_3_watch

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::Map, Eigen::Vector3d;

// The geom whose surface the centre of `body` met on its straight way from
// `before` to `now` (world, m); -1 where there is none.
int jumped(const mjModel* model, const mjData* data, int body,
           const Vector3d& before, const Vector3d& now) {
  // #region answer
  const double length = (now - before).norm();
  if (length < mjMINVAL) return -1;
  const Vector3d direction = (now - before) / length;
  int geom = -1;
  const double met = mj_ray(model, data, before.data(), direction.data(),
                            nullptr, 1, body, &geom);
  return met >= 0 && met <= length ? geom : -1;
  // #starter
  // return -1;  // cast a ray with mj_ray
  // #wrong sees-itself: the watch names the wall
  // const double length = (now - before).norm();
  // if (length < mjMINVAL) return -1;
  // const Vector3d direction = (now - before) / length;
  // int geom = -1;
  // const double met = mj_ray(model, data, before.data(), direction.data(),
  //                           nullptr, 1, -1, &geom);
  // return met >= 0 && met <= length ? geom : -1;
  // #wrong forgets-the-length: a ball that bounces
  // if (now == before) return -1;
  // const Vector3d direction = (now - before).normalized();
  // int geom = -1;
  // mj_ray(model, data, before.data(), direction.data(), nullptr, 1, body,
  //        &geom);
  // return geom;
  // #wrong knows-one-wall: a crate
  // const bool was_behind = before.x() > 0, is_behind = now.x() > 0;
  // return was_behind != is_behind ? mj_name2id(model, mjOBJ_GEOM, "wall") : -1;
  // #endregion
}

struct Throw {
  bool gets_through = false, is_seen = false;
  int told = -1;  // a geom
};

Throw throw_ball(const Model& model, const Data& data, double speed,
                 double nearer) {
  const int body = id_of(model, mjOBJ_BODY, "ball");
  const auto centre = [&] { return Vector3d(data->xpos + 3 * body); };
  mj_resetData(model, data);
  data->qpos[0] = nearer;
  data->qvel[0] = speed;
  mj_kinematics(model, data);
  Throw ball;
  while (data->time < 1 && std::abs(data->qpos[0] - 0.3) < 0.35) {
    const Vector3d before = centre();
    mj_step(model, data);
    ball.is_seen = ball.is_seen || data->ncon > 0;
    mj_kinematics(model, data);
    if (ball.told < 0) ball.told = jumped(model, data, body, before, centre());
  }
  ball.gets_through = data->qpos[0] > 0.3;
  return ball;
}

int main() {
  const Model model = load_model("thin_wall");
  const Data data = make_data(model);
  const int wall = id_of(model, mjOBJ_GEOM, "wall"), throws = 50;
  int wrong = 0;
  std::printf("m/s  through  unseen  told\n");
  for (const double speed : {1., 3., 10., 30., 100.}) {
    int through = 0, unseen = 0, told = 0;
    for (int i = 0; i < throws; ++i) {
      const double nearer = speed * model->opt.timestep * i / throws;
      const Throw ball = throw_ball(model, data, speed, nearer);
      through += ball.gets_through ? 1 : 0;
      unseen += ball.is_seen ? 0 : 1;
      told += ball.told >= 0 ? 1 : 0;
      wrong += ball.gets_through && ball.told != wall ? 1 : 0;
    }
    std::printf("%3.0f  %7d  %6d  %4d\n", speed, through, unseen, told);
    if (speed == 100.) result("unseen", unseen);
  }
  if (!expect(wrong == 0, "the watch names the wall that a ball got through",
              "the ray begins inside the ball's own geom"))
    return 0;
  if (!expect(throw_ball(model, data, 1, 0).told == -1,
              "a ball that bounces has jumped over nothing",
              "a ray goes on behind the end of the step"))
    return 0;
  const Model other = load_model_xml(
      "<mujoco><worldbody><geom name='crate' type='box' size='1 1 1' pos='5 0 "
      "0'/><body name='ball'><freejoint/><geom size='0.02'/></body>"
      "</worldbody></mujoco>");
  const Data there = make_data(other);
  mj_kinematics(other, there);
  expect(jumped(other, there, 1, {3, 0, 0}, {7, 0, 0}) == 0 &&
             jumped(other, there, 1, {3, 0, 0}, {3, 2, 0}) == -1,
         "a crate elsewhere is found, and only on the way",
         "the watch should know any model");
}
