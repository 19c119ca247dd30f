#include "script/world.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "physics/simulation.h"
#include "script/compiled_script.h"
#include "script/engine.h"
#include "script/js_value.h"
#include "script/native_world.h"

namespace mjcourse {

namespace {

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream rest(text);
  for (std::string line; std::getline(rest, line);) lines.push_back(line);
  return lines;
}

// The world's names become globals of the engine; gives what enterWorld() of
// site/press/script/entries/world.ts gives.
JSObjectRef enter(Engine& engine, const std::string& bundle, Simulation& simulation) {
  engine.load(bundle, "world.js");
  JSContextRef context = engine.context();
  JSObjectRef global = JSContextGetGlobalObject(context);
  const JSValueRef native = make_native_world(context, simulation);
  const auto entered =
      engine.call(object_in(context, property(context, global, "enterWorld")), {&native, 1});
  if (!entered) throw std::runtime_error("world.js: " + engine.describe(entered.error()).message);
  return object_in(context, *entered);
}

}  // namespace

// Everything behind the interface. A reader turns the value of a script into a type of C++.
struct World::Parts {
  template <typename T>
  using Expected = tl::expected<T, ScriptError>;
  template <typename T>
  using Reader = Expected<T> (Parts::*)(const CompiledScript&, JSValueRef);

  Parts(const std::string& bundle, Simulation& simulated, double time_limit)
      : engine(time_limit),
        simulation(simulated),
        entered(engine.context(), enter(engine, bundle, simulated)),
        names(split_lines(text_of(engine.context(), member("names")))) {}

  JSValueRef member(const char* name) { return property(engine.context(), entered, name); }

  Expected<JSValueRef> call(const CompiledScript& script, JSObjectRef function,
                            std::span<const JSValueRef> arguments = {}) {
    return engine.call(function, arguments).map_error([&](const Engine::Thrown& thrown) {
      return script.explain(engine, thrown, names);
    });
  }

  template <typename T>
  Expected<T> sample(std::string_view expression, Reader<T> read);
  template <typename T>
  Expected<T> prove(const Program& program, Reader<T> read);
  Expected<void> advance(double seconds);
  Expected<JSValueRef> resume(const CompiledScript& script, JSObjectRef iterator);

  Expected<double> number(const CompiledScript& script, JSValueRef value);
  Expected<bool> truth(const CompiledScript& script, JSValueRef value);
  Expected<nlohmann::json> json(const CompiledScript& script, JSValueRef value);
  Expected<JSValueRef> convert(const char* to, const CompiledScript& script, JSValueRef value);

  Engine engine;
  Simulation& simulation;
  Protected entered;
  CompiledScript::Names names;
  std::map<std::string, CompiledScript, std::less<>> expressions;  // by their text
};

template <typename T>
tl::expected<T, ScriptError> World::Parts::sample(std::string_view expression, Reader<T> read) {
  auto found = expressions.find(expression);
  if (found == expressions.end()) {
    const std::string text(expression);
    auto compiled = CompiledScript::compile(engine, std::nullopt, text, names);
    if (!compiled) return tl::unexpected(std::move(compiled.error()));
    found = expressions.emplace(text, std::move(*compiled)).first;
  }
  const CompiledScript& script = found->second;
  const auto value = call(script, script.function());
  if (!value) return tl::unexpected(value.error());
  return (this->*read)(script, *value);
}

template <typename T>
tl::expected<T, ScriptError> World::Parts::prove(const Program& program, Reader<T> read) {
  const auto script = CompiledScript::compile(engine, program.run, program.value, names);
  if (!script) return tl::unexpected(script.error());
  const auto iterator = call(*script, script->function());
  if (!iterator) return tl::unexpected(iterator.error());
  JSObjectRef steps = object_in(engine.context(), *iterator);
  const auto ran = resume(*script, steps);
  if (!ran) return tl::unexpected(ran.error());
  const auto advanced = advance(program.seconds);
  if (!advanced) return tl::unexpected(advanced.error());
  const auto value = resume(*script, steps);
  if (!value) return tl::unexpected(value.error());
  return (this->*read)(*script, *value);
}

tl::expected<void, ScriptError> World::Parts::advance(double seconds) {
  if (seconds == 0) return {};
  simulation.advance(seconds);
  if (!simulation.trouble()) return {};
  ScriptError error;
  error.id = "E-script-mujoco";
  error.message = simulation.trouble()->what;
  error.cure = simulation.trouble()->cure;
  return tl::unexpected(std::move(error));
}

// The iterator's next value; undefined once a `return` of the script has ended it.
tl::expected<JSValueRef, ScriptError> World::Parts::resume(const CompiledScript& script,
                                                           JSObjectRef iterator) {
  JSContextRef context = engine.context();
  const JSValueRef target = iterator;
  const auto step = call(script, object_in(context, member("next")), {&target, 1});
  if (!step) return tl::unexpected(step.error());
  return property(context, object_in(context, *step), "value");
}

tl::expected<double, ScriptError> World::Parts::number(const CompiledScript& script,
                                                       JSValueRef value) {
  JSContextRef context = engine.context();
  double number = NAN;
  if (JSValueIsNumber(context, value)) number = JSValueToNumber(context, value, nullptr);
  if (std::isfinite(number)) return number;
  return convert("asNumber", script, value).map([&](JSValueRef converted) {
    return JSValueToNumber(context, converted, nullptr);
  });
}

tl::expected<bool, ScriptError> World::Parts::truth(const CompiledScript& script,
                                                    JSValueRef value) {
  return convert("asTruth", script, value).map([&](JSValueRef converted) {
    return JSValueToBoolean(engine.context(), converted);
  });
}

tl::expected<nlohmann::json, ScriptError> World::Parts::json(const CompiledScript& script,
                                                             JSValueRef value) {
  return convert("asJson", script, value).map([&](JSValueRef converted) {
    return json_of(text_of(engine.context(), converted));
  });
}

// What a function of site/press/script/result.ts makes of `value`. What it refuses is the fault of
// the whole expression.
tl::expected<JSValueRef, ScriptError> World::Parts::convert(const char* to,
                                                            const CompiledScript& script,
                                                            JSValueRef value) {
  auto converted = call(script, object_in(engine.context(), member(to)), {&value, 1});
  if (!converted) script.point_at_value(converted.error());
  return converted;
}

World::World(const std::string& bundle, Simulation& simulation, double time_limit)
    : parts_(std::make_unique<Parts>(bundle, simulation, time_limit)) {}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

const std::vector<std::string>& World::names() const {
  return parts_->names;
}

tl::expected<void, ScriptError> World::run(const std::string& script) {
  const auto compiled = CompiledScript::compile(parts_->engine, script, {}, parts_->names);
  if (!compiled) return tl::unexpected(compiled.error());
  return parts_->call(*compiled, compiled->function()).map([](JSValueRef) {});
}

tl::expected<void, ScriptError> World::assign(const std::string& target, double value) {
  const auto compiled = CompiledScript::compile_assignment(parts_->engine, target, parts_->names);
  if (!compiled) return tl::unexpected(compiled.error());
  const JSValueRef number = JSValueMakeNumber(parts_->engine.context(), value);
  return parts_->call(*compiled, compiled->function(), {&number, 1}).map([](JSValueRef) {});
}

tl::expected<double, ScriptError> World::number(std::string_view expression) {
  return parts_->sample(expression, &Parts::number);
}

tl::expected<double, ScriptError> World::number(const Program& program) {
  return parts_->prove(program, &Parts::number);
}

tl::expected<bool, ScriptError> World::truth(std::string_view expression) {
  return parts_->sample(expression, &Parts::truth);
}

tl::expected<bool, ScriptError> World::truth(const Program& program) {
  return parts_->prove(program, &Parts::truth);
}

tl::expected<nlohmann::json, ScriptError> World::value(std::string_view expression) {
  return parts_->sample(expression, &Parts::json);
}

tl::expected<nlohmann::json, ScriptError> World::value(const Program& program) {
  return parts_->prove(program, &Parts::json);
}

}  // namespace mjcourse
