// Lesson 5.1: does it work, or did it work once? Fifty starts, all different.
//
// INPUT    pick_place.xml; the seed of a random number generator
// PROCESS  draw fifty starts: where the three objects are, which one to take,
//          its mass and friction, how far the camera is off. Reach for each,
//          and take it to the tray, once with 0.6 s of patience, and once more
//          from there with none
// OUTPUT   how many of them arrive; of the others, the room that the fingers
//          had beside the object, and the weight that friction could carry
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l5_1_fifty_starts

#include <cstdio>
#include <mjcourse/trial.hpp>

using namespace mjcourse;

int main() {
  const Model model = load_model("pick_place");
  std::mt19937 random(1);
  int placed = 0, placed_hastily = 0, foretold = 0, slippery = 0;
  std::printf("start  not placed  room       could carry  weight\n");
  for (int i = 1; i <= 50; ++i) {
    const Start start = draw(random);
    const Trial trial(start, model);
    const auto [room, could, weight, in_tray] = trial.carry(0.6);
    placed += in_tray;
    placed_hastily += trial.carry(0).placed;
    foretold += in_tray == (room > 0 && could > weight);
    slippery += could < weight;
    if (in_tray) continue;
    std::printf("%4d   %-10s  %5.1f mm     %5.2f N   %5.2f N\n", i,
                kHolds[start.which].object, 1000 * room, could, weight);
  }
  std::printf("placed: %d of 50; without patience: %d of 50\n", placed,
              placed_hastily);

  result("placed", placed);
  result("failed", 50 - placed);
  result("placed_hastily", placed_hastily);
  result("foretold", foretold);
  result("slippery", slippery);
}
