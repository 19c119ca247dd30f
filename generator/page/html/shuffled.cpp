#include "page/html/shuffled.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace mjcourse {
namespace {

// The standard library's generators repeat, but what it draws with them differs between libraries;
// so both are written out here: FNV-1a for the seed, splitmix64 for the numbers.
class Draw {
 public:
  explicit Draw(std::string_view seed) {
    for (const char c : seed) state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  std::size_t below(std::size_t end) {
    state_ += 0x9e3779b97f4a7c15;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return static_cast<std::size_t>((z ^ (z >> 31)) % end);
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325;
};

}  // namespace

std::vector<std::size_t> shuffled(std::size_t count, std::string_view seed) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  Draw draw(seed);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[draw.below(i)]);
  if (std::is_sorted(order.begin(), order.end())) {
    std::rotate(order.begin(), order.begin() + 1, order.end());
  }
  return order;
}

}  // namespace mjcourse
