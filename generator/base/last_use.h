// When something was last used, as the time of its file says.
//
// A file's owner may give it any time, and one in the future would keep it for ever.
#pragma once

#include <sys/stat.h>

#include <compare>
#include <ctime>
#include <limits>

namespace mjcourse {

struct LastUse {
  std::time_t seconds = std::numeric_limits<std::time_t>::min();  // never
  long nanoseconds = 0;
  auto operator<=>(const LastUse&) const = default;

  // `file` is as lstat(2) gives it, without following a link. Clocks of machines that share a disk
  // differ, but not by an hour: what is further ahead than that counts as never used.
  static LastUse of(const struct stat& file);
};

// To be told anew: it was an hour ago, or is to come.
bool is_use_outdated(const struct stat& file);

}  // namespace mjcourse
