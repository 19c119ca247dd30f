// World: the author's scripts over a simulation, as build and page both run them.
//
// Enter with run(), number() and truth(). A script sees `model` and `data` with MuJoCo's own field
// names, lookups by name (`qpos('hinge')`, `body('box').xpos`), step(), forward(), reset(),
// MuJoCo's functions and constants, Math, and nothing else. Fields are views on MuJoCo's memory: no
// copy is made, and whatever steps the simulation is seen at once.
//
// The names and their strictness are made by site/press/script/world.ts, the same code that runs in
// the page; this class gives it the native half (native_world.h) and finds an error's place in the
// author's text (author_text.h). An expression is compiled once, so sampling it at every frame
// costs a call and no parse.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "script/script_error.h"

namespace mjcourse {

class Simulation;

// A script, time that passes, and an expression that sees what the script declared.
struct Program {
  std::string run;
  double seconds = 0;  // of simulated time between `run` and `value`
  std::string value;
};

class World {
 public:
  // `bundle` is the text of script/world.js. The simulation, its model and its data must outlive
  // the world. `time_limit` is in seconds of CPU time and holds for each call; the `seconds` of a
  // Program do not count.
  World(const std::string& bundle, Simulation& simulation, double time_limit = 5);
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  // What a script may use, the same in every world.
  const std::vector<std::string>& names() const;

  tl::expected<void, ScriptError> run(const std::string& script);

  // Runs `TARGET = value`: the target is the author's, a place such as data.ctrl[0].
  tl::expected<void, ScriptError> assign(const std::string& target, double value);

  // A finite number; an array of one number, such as qpos('hinge'), counts as that number.
  tl::expected<double, ScriptError> number(std::string_view expression);
  tl::expected<double, ScriptError> number(const Program& program);

  tl::expected<bool, ScriptError> truth(std::string_view expression);
  tl::expected<bool, ScriptError> truth(const Program& program);

  // A finite number, a boolean, a string, or an array of these. Callers include nlohmann/json.hpp.
  tl::expected<nlohmann::json, ScriptError> value(std::string_view expression);
  tl::expected<nlohmann::json, ScriptError> value(const Program& program);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace mjcourse
