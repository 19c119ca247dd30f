#include "physics/mujoco_guard.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <filesystem>
#include <thread>

#include "physics/data.h"
#include "physics/model.h"

namespace mjcourse {
namespace {

// Unguarded, each of these would ask for the Enter key and end the process.
TEST(MujocoGuard, TurnsAnErrorIntoAnException) {
  install_mujoco_guard();
  EXPECT_THROW(mju_error("no such thing"), MujocoError);
  try {
    mju_error_s("no such thing as %s", "this");
    FAIL() << "mju_error returned";
  } catch (const MujocoError& error) {
    EXPECT_STREQ(error.what(), "no such thing as this");
  }
}

TEST(MujocoGuard, ThrowsThroughMujocosOwnFrames) {
  Model model = load_model_text(
                    "<mujoco><worldbody><body><freejoint/><geom size='1'/></body>"
                    "</worldbody></mujoco>")
                    .value();
  model->nstack = 1;  // mj_forward needs more
  Data data(model);
  EXPECT_THROW(mj_forward(model.get(), data.get()), MujocoError);
}

TEST(MujocoGuard, CollectsWarningsInTheInnermostLogOfTheThread) {
  WarningLog outer;
  mju_warning("one");
  {
    WarningLog inner;
    mju_warning("two");
    EXPECT_EQ(inner.warnings(), std::vector<std::string>{"two"});
    std::thread([] { mju_warning("another thread's"); }).join();
    EXPECT_EQ(inner.warnings().size(), 1u);
  }
  mju_warning("three");
  EXPECT_EQ(outer.warnings(), (std::vector<std::string>{"one", "three"}));
}

TEST(MujocoGuard, LeavesNoLogFileBehind) {
  install_mujoco_guard();
  std::filesystem::remove("MUJOCO_LOG.TXT");
  mju_warning("nobody listens");
  EXPECT_THROW(mju_error("nobody waits"), MujocoError);
  EXPECT_FALSE(std::filesystem::exists("MUJOCO_LOG.TXT"));
}

}  // namespace
}  // namespace mjcourse
