// MuJoCo as the generator has it, for the engine's tests to be compared with.
//
//   engine_native state STEPS MODEL   the state after so many steps, as hexadecimal doubles
//   engine_native speed STEPS MODEL   steps per second
#include <bit>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "physics/simulation.h"
#include "state.h"

namespace {

mjcourse::Simulation simulation_of(const std::string& path) {
  auto model = mjcourse::load_model_file(path);
  if (!model) throw std::runtime_error(path + ": " + model.error().message);
  return mjcourse::Simulation(*std::move(model));
}

void check(const mjcourse::Simulation& simulation) {
  if (simulation.trouble()) throw std::runtime_error(simulation.trouble()->what);
}

void print_state(const std::string& path, int steps) {
  auto simulation = simulation_of(path);
  simulation.step(steps);
  check(simulation);
  std::vector<double> state(static_cast<std::size_t>(mjc_state_size(simulation.model().get())));
  mjc_get_state(simulation.model().get(), simulation.data().get(), state.data());
  for (const double number : state) {
    std::printf("%016llx", static_cast<unsigned long long>(std::bit_cast<std::uint64_t>(number)));
  }
  std::printf("\n");
}

void print_speed(const std::string& path, int steps) {
  auto simulation = simulation_of(path);
  const auto start = std::chrono::steady_clock::now();
  simulation.step(steps);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  check(simulation);
  std::printf("%.0f\n", steps / taken.count());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::string what = argv[1];
  const int steps = std::atoi(argv[2]);
  try {
    what == "speed" ? print_speed(argv[3], steps) : print_state(argv[3], steps);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
