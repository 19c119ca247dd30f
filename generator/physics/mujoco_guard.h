// MuJoCo's two ways of speaking up, made safe for a program nobody sits in front of.
//
// Left alone, mju_error prints, asks to press Enter and ends the process, and both mju_error and
// mju_warning write MUJOCO_LOG.TXT. Under the guard an error is a MujocoError, thrown through
// MuJoCo's C frames, and a warning goes to the WarningLog of its thread. Everything in physics/
// that calls MuJoCo first calls install_mujoco_guard().
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace mjcourse {

// What MuJoCo said through mju_error. The mjData or mjModel at work may be half changed: reset or
// delete it.
class MujocoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Sets mju_user_error and mju_user_warning for the process; again and from any thread is fine.
void install_mujoco_guard();

// Collects what mju_warning says on this thread while it lives. Logs nest: the innermost collects.
// A warning that no log is there to collect is lost.
class WarningLog {
 public:
  WarningLog();
  ~WarningLog();
  WarningLog(const WarningLog&) = delete;
  WarningLog& operator=(const WarningLog&) = delete;

  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  friend void collect_warning(const char* message);

  std::vector<std::string> warnings_;
  WarningLog* outer_;
};

}  // namespace mjcourse
