#include "physics/mujoco_guard.h"

#include <mujoco/mujoco.h>

namespace mjcourse {
namespace {

thread_local WarningLog* innermost_log = nullptr;

[[noreturn]] void throw_error(const char* message) {
  throw MujocoError(message);
}

}  // namespace

void collect_warning(const char* message) {
  if (innermost_log != nullptr) innermost_log->warnings_.emplace_back(message);
}

void install_mujoco_guard() {
  static const bool installed = [] {
    mju_user_error = throw_error;
    mju_user_warning = collect_warning;
    return true;
  }();
  static_cast<void>(installed);
}

WarningLog::WarningLog() : outer_(innermost_log) {
  install_mujoco_guard();
  innermost_log = this;
}

WarningLog::~WarningLog() {
  innermost_log = outer_;
}

}  // namespace mjcourse
