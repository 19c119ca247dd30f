// Lesson 1.3: what each stage of a step finds out.
//
// INPUT    arm_and_crate.xml, while the arm pushes the crate
// PROCESS  forget every result in mjData; let MuJoCo's own timers run on a clock
//          that counts the numbers which are known; take one step
// OUTPUT   how many numbers each stage has found; for the lesson, the table
//          "stages". With the word "seconds": a real clock, and 10000 steps
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_3_stages
//      build/l1_3_stages seconds

#include <mujoco/mjxmacro.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <mjcourse/mjcourse.hpp>
#include <set>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

using namespace mjcourse;

// A clock has no arguments, so what it looks at is global.
std::vector<std::span<double>> results;

// All arrays of numbers in `data` but the state and the inputs.
std::vector<std::span<double>> find_results(const mjModel* m, mjData* data) {
  const std::set<std::string_view> given{
      "qpos",           "qvel",         "act",          "ctrl",
      "qacc_warmstart", "qfrc_applied", "xfrc_applied", "mocap_pos",
      "mocap_quat",     "userdata"};
  std::vector<std::span<double>> found;
  const auto keep = [&](const char* name, auto* array, std::size_t size) {
    if constexpr (std::is_same_v<decltype(array), double*>)
      if (!given.contains(name)) found.emplace_back(array, size);
  };
  MJDATA_POINTERS_PREAMBLE(m)
#define X(type, name, rows, columns) \
  keep(#name, data->name, std::size_t(m->rows) * (columns));
  MJDATA_POINTERS
#undef X
  return found;
}

// #region clock
double numbers_known() {
  double known = 0;
  for (const std::span<double> array : results)
    for (const double x : array) known += !std::isnan(x);
  return known;
}

double seconds() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}
// #endregion

int main(int argc, char** argv) {
  const bool real = argc > 1 && std::string_view(argv[1]) == "seconds";
  const Model model = load_model("arm_and_crate");
  const Data data = make_data(model);
  ctrl(model, data) << 1.4, 1.8;
  for (int step = 0; step < 300; ++step) mj_step(model, data);

  // #region timers
  results = find_results(model, data);
  for (const std::span<double> array : results)
    std::ranges::fill(array, std::numeric_limits<double>::quiet_NaN());

  mjcb_time = real ? seconds : numbers_known;
  for (int step = 0; step < (real ? 10000 : 1); ++step) mj_step(model, data);
  mjcb_time = nullptr;

  const auto spent = [&](auto timer) { return data->timer[timer].duration; };
  // #endregion
  const double all = spent(mjTIMER_FORWARD);
  std::vector<double> number, found;
  for (const char* name :
       {"position", "velocity", "actuation", "acceleration", "constraint"}) {
    // MuJoCo's timers of the stages follow one another in the same order.
    found.push_back(spent(mjTIMER_POSITION + number.size()));
    number.push_back(number.size() + 1.0);
    std::printf("%-13s %5.3g  %3.0f %%\n", name, found.back(),
                100 * found.back() / all);
    result(name, found.back());
  }
  result("all", all);
  result("before", 100 * (found[0] + found[1]) / all);  // %
  table("stages", {{"stage", number}, {"found", found}});
}
