// Lesson 1.3: what each stage of a step finds out.
//
// INPUT    arm_and_crate.xml, while the arm pushes the crate; three arms that
//          touch nothing; nine boxes on a floor
// PROCESS  forget every result in mjData; let MuJoCo's own timers run on a clock
//          that counts the numbers which are known; take one step. Then give
//          them a clock in seconds, and take a thousand
// OUTPUT   how many numbers each stage has found; for each model, the share of
//          the numbers and of the time that comes before the control. With the
//          word "seconds": that share of the time in per cent, which differs
//          from machine to machine; for the lesson, the table "stages"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_3_stages
//      build/l1_3_stages seconds

#include <mujoco/mjxmacro.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <mjcourse/mjcourse.hpp>
#include <set>
#include <span>
#include <string>
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

// What the timers of MuJoCo's stages have added up so far, in their order.
std::vector<double> spent(const mjData* data) {
  std::vector<double> durations;
  for (int timer = mjTIMER_POSITION; timer <= mjTIMER_CONSTRAINT; ++timer)
    durations.push_back(data->timer[timer].duration);
  return durations;
}

// #region timers
// How many numbers each stage of one step finds.
std::vector<double> count(const mjModel* model, mjData* data) {
  results = find_results(model, data);
  for (const std::span<double> array : results)
    std::ranges::fill(array, std::numeric_limits<double>::quiet_NaN());
  for (mjTimerStat& timer : data->timer) timer = {};
  mjcb_time = numbers_known;
  mj_step(model, data);
  mjcb_time = nullptr;
  return spent(data);
}
// #endregion

// The share of the first two stages.
double before(const std::vector<double>& stages) {
  double all = 0;
  for (const double stage : stages) all += stage;
  return (stages[0] + stages[1]) / all;
}

// #region time
// The share of a step's time, the median of a thousand steps: so it does not
// matter if the machine does something else meanwhile.
double before_in_time(const mjModel* model, mjData* data) {
  std::vector<double> shares;
  mjcb_time = seconds;
  for (int step = 0; step < 1000; ++step) {
    for (mjTimerStat& timer : data->timer) timer = {};
    mj_step(model, data);
    shares.push_back(before(spent(data)));
  }
  mjcb_time = nullptr;
  std::ranges::nth_element(shares, shares.begin() + 500);
  return shares[500];
}
// #endregion

// Side by side, each on its four corners.
Model nine_boxes() {
  std::string boxes;
  for (const char* y : {"0", "0.3", "0.6"})
    for (const char* x : {"0", "0.3", "0.6"})
      boxes += "<body pos='" + std::string(x) + " " + y +
               " 0.1'><freejoint/><geom type='box' size='0.1 0.1 0.1'/></body>";
  return load_model_xml(
      "<mujoco><worldbody><geom type='plane' size='2 2 0.1'/>" + boxes +
      "</worldbody></mujoco>");
}

int main(int argc, char** argv) {
  const bool exact = argc > 1 && std::string_view(argv[1]) == "seconds";
  const Model arm = load_model("arm_and_crate");
  const Data data = make_data(arm);
  ctrl(arm, data) << 1.4, 1.8;
  for (int step = 0; step < 300; ++step) mj_step(arm, data);

  const std::vector<double> found = count(arm, data);
  double all = 0;
  for (const double stage : found) all += stage;
  std::vector<double> number;
  for (const char* name :
       {"position", "velocity", "actuation", "acceleration", "constraint"}) {
    const double numbers = found[number.size()];
    number.push_back(number.size() + 1.0);
    std::printf("%-13s %5.3g  %3.0f %%\n", name, numbers, 100 * numbers / all);
    result(name, numbers);
  }
  result("before", 100 * before(found));  // %
  table("stages", {{"stage", number}, {"found", found}});

  std::printf("\nbefore your control  numbers  time\n");
  const auto compare = [&](const char* name, const Model& model,
                           mjData* state) {
    for (int step = 0; step < 300; ++step) mj_step(model, state);
    const double time = before_in_time(model, state);
    std::printf("%-19s  %4.0f %%   ", name, 100 * before(count(model, state)));
    if (exact)
      std::printf("%.0f %%\n", 100 * time);
    else
      std::printf("%s than half\n", time > 0.5 ? "more" : "less");
  };
  const Model arms = load_model("three_arms"), boxes = nine_boxes();
  compare("three arms", arms, make_data(arms));
  compare("the arm, its crate", arm, data);
  compare("nine boxes", boxes, make_data(boxes));
}
