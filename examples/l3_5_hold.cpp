// Lesson 3.5: the same noise, held for longer, gets farther.
//
// INPUT    puck_table.xml without its puck's contact; pushes along x of 1 N
//          times a normal number, which is drawn afresh every few steps
// PROCESS  simulate 400 such pushes for each time of holding
// OUTPUT   how far the pusher is spread after a second, measured and derived
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_5_hold

#include <cmath>
#include <cstdio>
#include <vector>

#include "l3_5_plan.hpp"

using namespace mjcourse;

int main() {
  const Model model = load_model("puck_table");
  model->opt.disableflags |= mjDSBL_CONTACT;  // only the pusher counts
  const Data data = make_data(model);
  const int N = 100, draws = 400;
  const double h = model->opt.timestep, mass = 1;
  std::printf("held for  spread of the pusher (m)  derived\n");
  std::vector<double> holds, spreads, formula;
  std::mt19937 random(1);
  for (const int hold : {1, 2, 5, 10, 20, 50, 100}) {
    double squares = 0;
    for (int draw = 0; draw < draws; ++draw) {
      cost_of(model, data, noise(N, {0, hold, 1.0}, random));
      squares += data->qpos[0] * data->qpos[0];
    }
    // #region derived
    double variance = 0;
    for (int first = 0; first < N; first += hold) {
      double reach = 0;  // of 1 N in these steps, at the end, in metres
      for (int t = first; t < first + hold; ++t)
        reach += h * h / mass * (N - t);
      variance += reach * reach;
    }
    // #endregion
    holds.push_back(hold * h);
    spreads.push_back(std::sqrt(squares / draws));
    formula.push_back(std::sqrt(variance));
    if (hold != 2 && hold != 5 && hold != 50)
      std::printf("%6.2f s  %24.3f  %7.3f\n", holds.back(), spreads.back(),
                  formula.back());
    result("spread_" + std::to_string(hold), spreads.back());
  }
  table("spreads",
        {{"held", holds}, {"measured", spreads}, {"derived", formula}});
}
