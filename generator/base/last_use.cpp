#include "base/last_use.h"

namespace mjcourse {
namespace {

constexpr std::time_t kHour = 3600;  // seconds

bool is_to_come(const struct stat& file) {
  return file.st_mtim.tv_sec > std::time(nullptr) + kHour;
}

}  // namespace

LastUse LastUse::of(const struct stat& file) {
  if (is_to_come(file)) return {};
  return {file.st_mtim.tv_sec, file.st_mtim.tv_nsec};
}

bool is_use_outdated(const struct stat& file) {
  return file.st_mtim.tv_sec <= std::time(nullptr) - kHour || is_to_come(file);
}

}  // namespace mjcourse
