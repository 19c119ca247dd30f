#include "evaluate/concurrency.h"

#include <algorithm>

namespace mjcourse {

Concurrency concurrency_of(std::size_t threads, std::uint64_t memory) {
  constexpr std::uint64_t enough = 512 << 20;  // for a lab of an ordinary course, twice over
  const std::uint64_t workers = memory / 4 * 3;
  const auto most = static_cast<std::size_t>(std::max<std::uint64_t>(workers / enough, 1));
  Concurrency concurrency{std::min(threads, most), {}};
  if (concurrency.threads > 0)
    concurrency.limits.memory = std::min(concurrency.limits.memory, workers / concurrency.threads);
  return concurrency;
}

}  // namespace mjcourse
