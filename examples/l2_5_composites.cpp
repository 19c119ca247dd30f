// Lesson 2.5: what composites generate, and what it costs.
//
// INPUT    a rope, and square cloths of both types, all 0.6 m long, of more
//          and more elements; the word `seconds` asks for times as well
// PROCESS  compile them, and let them fall for a few steps
// OUTPUT   degrees of freedom, entries of the mass matrix, tendons, rows of
//          constraints; which of the finest cloths takes longer; for the
//          lesson, the table "sizes"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_5_composites [seconds]

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>
#include <vector>

using namespace mjcourse;

// #region composite
// A composite of n by m elements, held at one end or corner.
std::string composite(const std::string& type, int n, int m) {
  const std::string inside =
      "<composite type='" + type + "' count='" + std::to_string(n) + " " +
      std::to_string(m) + " 1' spacing='" + std::to_string(0.6 / (n - 1)) +
      "'><joint kind='main' damping='0.001'/><geom size='0.005'/>";
  if (type == "grid") return inside + "<pin coord='0 0'/></composite>";
  const std::string parent = type == "rope" ? "B0" : "B0_0";
  return "<body name='" + parent + "'>" + inside + "</composite></body>";
}
// #endregion

// The median of what so many steps take, in microseconds.
double median(const Model& model, const Data& data, int steps) {
  std::vector<double> times;
  for (int step = 0; step < steps; ++step) {
    const auto start = std::chrono::steady_clock::now();
    mj_step(model, data);
    const std::chrono::duration<double, std::micro> took =
        std::chrono::steady_clock::now() - start;
    times.push_back(took.count());
  }
  std::sort(times.begin(), times.end());
  return times[steps / 2];
}

int main(int count, char** words) {
  const bool seconds = count > 1 && std::string(words[1]) == "seconds";
  std::vector<double> kinds, sizes, dofs, entries;
  std::printf("type   elements    nv     nM  tendons  rows%s\n",
              seconds ? "  microseconds" : "");
  const auto show = [&](int kind, int n, int m) {
    const std::string type = std::vector{"rope", "grid", "cloth"}[kind];
    const Model model = load_model_xml(
        "<mujoco><option solver='CG' tolerance='1e-6'>"
        "<flag contact='disable'/></option>"
        "<size njmax='2000' nstack='2000000'/><worldbody>" +
        composite(type, n, m) + "</worldbody></mujoco>");
    const Data data = make_data(model);
    const double time = median(model, data, seconds ? 100 : 20);
    std::printf("%-5s  %3d x %-2d  %4d  %5d  %7d  %4d", type.c_str(), n, m,
                model->nv, model->nM, model->ntendon, data->nefc);
    if (seconds) std::printf("  %12.0f", time);
    std::printf("\n");
    kinds.push_back(kind);
    sizes.push_back(n * m);
    dofs.push_back(model->nv);
    entries.push_back(model->nM);
    const std::string of = "_" + std::to_string(n);
    result(type + "_nv" + of, model->nv);
    result(type + "_nM" + of, model->nM);
    return time;
  };
  for (const int n : {10, 20, 40, 80}) show(0, n, 1);
  for (const int n : {5, 10}) show(1, n, n);
  const double grid = show(1, 20, 20);
  for (const int n : {5, 10}) show(2, n, n);
  const double cloth = show(2, 20, 20);
  std::printf("20 x 20: a step of the cloth takes longer: %s\n",
              cloth > grid ? "yes" : "no");
  table("sizes",
        {{"kind", kinds}, {"elements", sizes}, {"nv", dofs}, {"nM", entries}});
}
