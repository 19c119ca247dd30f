// A world over a small robot: one joint of each type, a motor, two sensors.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "bundle.h"
#include "physics/simulation.h"
#include "script/world.h"

namespace mjcourse {

inline constexpr const char* robot = R"(
<mujoco>
  <option gravity="0 0 -10" timestep="0.002">
    <flag contact="disable" energy="enable"/>
  </option>
  <worldbody>
    <body name="box" pos="1 2 3">
      <freejoint name="free"/>
      <geom name="side" size="0.1" mass="2"/>
      <site name="tip" pos="0 0 0.5"/>
    </body>
    <body name="bob"><joint name="ball" type="ball"/><geom size="0.1" pos="0 0 -1"/></body>
    <body name="cart"><joint name="slide" type="slide"/><geom size="0.1"/></body>
    <body name="wheel"><joint name="hinge" axis="0 1 0"/><geom size="0.1"/></body>
  </worldbody>
  <actuator><motor name="motor" joint="hinge"/></actuator>
  <sensor>
    <jointpos name="angle" joint="hinge"/>
    <framepos name="place" objtype="site" objname="tip"/>
  </sensor>
</mujoco>)";

inline Simulation simulate(const std::string& mjcf) {
  auto model = load_model_text(mjcf);
  if (!model) throw std::runtime_error(model.error().message);
  return Simulation(std::move(*model));
}

class WorldTest : public testing::Test {
 protected:
  double number(std::string_view expression) {
    const auto result = world_.number(expression);
    if (!result) ADD_FAILURE() << expression << ": " << shown(result.error());
    return result.value_or(-12345);
  }

  // "id line:column+width message | cure" of what `script` or `expression` ends with.
  std::string run_error(const std::string& script) {
    const auto result = world_.run(script);
    return result ? "no error" : shown(result.error());
  }
  std::string value_error(const std::string& expression) {
    const auto result = world_.number(expression);
    return result ? "no error" : shown(result.error());
  }

  static std::string shown(const ScriptError& error) {
    std::string place = std::to_string(error.line) + ":" + std::to_string(error.column) + "+" +
                        std::to_string(error.width);
    return error.id + " " + place + " " + error.message + " | " + error.cure;
  }

  Simulation simulation_ = simulate(robot);
  World world_{bundle("world"), simulation_, 0.2};
};

}  // namespace mjcourse
