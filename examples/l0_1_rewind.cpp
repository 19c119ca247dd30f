// Lesson 0.1, challenge: which numbers bring a simulation back?
//
// INPUT    falling_box.xml
// PROCESS  at each of 500 steps, keep some of the state; take 100 steps more;
//          put what was kept into fresh data, take those 100 steps again
// OUTPUT   whether some of the 500 replays end at another height: with the
//          first guess, and with copy_state; checks the replays of copy_state
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_1_rewind

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

using Copy = void(const mjModel* model, const mjData* from, mjData* to);

void first_guess(const mjModel* model, const mjData* from, mjData* to) {
  to->time = from->time;
  std::copy_n(from->qpos, model->nq, to->qpos);
  std::copy_n(from->qvel, model->nv, to->qvel);
}

// Copies the numbers that `from` needs to go on into `to`, which is fresh: from
// there, the same steps give the same bits. Copies nothing else: most numbers
// of an mjData are computed anew in each step.
void copy_state(const mjModel* model, const mjData* from, mjData* to) {
  // #region answer
  to->time = from->time;
  std::copy_n(from->qpos, model->nq, to->qpos);
  std::copy_n(from->qvel, model->nv, to->qvel);
  std::copy_n(from->qacc_warmstart, model->nv, to->qacc_warmstart);
  // #starter
  // // Begin like the first guess. Which array is missing there?
  // #wrong forgets-the-time: the replay has the original's time
  // std::copy_n(from->qpos, model->nq, to->qpos);
  // std::copy_n(from->qvel, model->nv, to->qvel);
  // std::copy_n(from->qacc_warmstart, model->nv, to->qacc_warmstart);
  // #wrong forgets-the-velocity: in the air, the replay
  // to->time = from->time;
  // std::copy_n(from->qpos, model->nq, to->qpos);
  // std::copy_n(from->qacc_warmstart, model->nv, to->qacc_warmstart);
  // #wrong first-guess: landing, the replay
  // first_guess(model, from, to);
  // #wrong qacc: landing, the replay
  // first_guess(model, from, to);
  // std::copy_n(from->qacc, model->nv, to->qacc);
  // #wrong everything: what follows from the state
  // mj_copyData(to, model, from);
  // #endregion
}

// Keeps some of `data`, and puts it into `replay`; both begin as fresh data.
void rewind(const Model& model, const Data& data, Copy* copy, const Data& kept,
            const Data& replay) {
  mj_resetData(model, kept);
  mj_resetData(model, replay);
  copy(model, data, kept);
  copy(model, kept, replay);
}

double height_later(const Model& model, const Data& data) {
  for (int n = 0; n < 100; ++n) mj_step(model, data);
  return data->qpos[0];
}

bool same(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

int main() {
  const Model model = load_model("falling_box");
  const Data data = make_data(model), original = make_data(model);
  const Data kept = make_data(model), replay = make_data(model);
  Copy* const copies[] = {first_guess, copy_state};
  // Replays that end with other bits, by the first guess and by copy_state.
  int in_the_air[2] = {}, landing[2] = {};
  bool is_time = true, is_little = true;
  for (int n = 0; n < 500; ++n) {
    const bool falling = data->time < 0.34;  // and the 100 steps after it
    mj_copyData(original, model, data);
    const double height = height_later(model, original);
    for (const int c : {0, 1}) {
      rewind(model, data, copies[c], kept, replay);
      if (c == 1) {
        is_time = is_time && replay->time == data->time;
        is_little = is_little && replay->xpos[5] == 0;  // the box's height
      }
      (falling ? in_the_air : landing)[c] +=
          !same(height_later(model, replay), height);
    }
    mj_step(model, data);
  }
  const auto word = [](int count) { return count == 0 ? "none" : "some"; };
  std::printf("replays that end with other bits  in the air  landing\n");
  std::printf("time, qpos, qvel                  %-10s  %s\n",
              word(in_the_air[0]), word(landing[0]));
  std::printf("copy_state                        %-10s  %s\n",
              word(in_the_air[1]), word(landing[1]));
  result("differ", landing[0]);

  expect(is_time, "the replay has the original's time");
  if (expect(in_the_air[1] == 0, "in the air, the replay has the same bits",
             "a number that even a free fall needs is not copied"))
    expect(landing[1] == 0, "landing, the replay has the same bits, too",
           "the solver for the contact begins elsewhere than in the original");
  expect(is_little, "what follows from the state is not copied",
         "each step computes places of bodies, forces and contacts anew");
}
