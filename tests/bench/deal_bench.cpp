// How long the tasks of a large course are dealt: the part of shards.mjs that has no course.
//
//   deal_bench PORTIONS SHARDS
//
// One portion in ten was edited. They take between a millisecond and two seconds. Prints the
// seconds as JSON; how even the shares are, shard_test.cpp says.
#include <chrono>
#include <cstddef>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/stopwatch.h"
#include "evaluate/shard.h"

int main(int count, char** arguments) {
  if (count != 3) return 2;
  const std::size_t shards = std::stoul(arguments[2]);
  std::vector<mjcourse::Portion> portions(std::stoul(arguments[1]));
  for (std::size_t i = 0; i < portions.size(); ++i) {
    mjcourse::Portion& portion = portions[i];
    portion.name = "content/lesson.md: task " + std::to_string(i);
    (i % 10 == 0 ? portion.edited : portion.kept) =
        std::chrono::microseconds(1'000 + i * 7919 % 2'000'000);
  }
  const mjcourse::Stopwatch stopwatch;
  deal(portions, shards);
  const double seconds = stopwatch.seconds();
  std::cout << nlohmann::json{{"portions", portions.size()},
                              {"shards", shards},
                              {"seconds", seconds}}
            << "\n";
}
