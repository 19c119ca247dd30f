#include "script/engine.h"

#include <jsc/jsc.h>

#include <array>
#include <sstream>
#include <stdexcept>

#include "script/exception.h"
#include "script/js_value.h"

namespace mjcourse {
namespace {

const LateFunction<kScriptEngine, decltype(::jsc_options_set_boolean)> jsc_options_set_boolean(
    "jsc_options_set_boolean");
const LateFunction<kScriptEngine, decltype(::jsc_options_set_size)> jsc_options_set_size(
    "jsc_options_set_size");

// The clock stands at the first second of 2000 (UTC), and chance is the generator mulberry32.
constexpr const char* fixed_surroundings = R"js(
  const instant = Date.UTC(2000, 0, 1);
  Date.now = () => instant;
  globalThis.Date = new Proxy(Date, {
    construct: (target, args) => new target(...(args.length > 0 ? args : [instant])),
    apply: (target) => new target(instant).toISOString(),
  });
  let state = 1;
  Math.random = () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
)js";

constexpr std::size_t kSupposedMemory = std::size_t{1} << 30;  // bytes

// JavaScriptCore's options hold for the process and must be set before its first realm. With
// usePollingTraps running code asks by itself whether its time is up; the default, to patch its
// machine code from another thread, now and then misses an endless loop. Without useTailCalls every
// call keeps its frame, and so every error its place. A tenth of the processor's time goes to its
// last compiler, useFTLJIT, for code that is soon not run any more; and it lets garbage grow with
// the machine's memory unless it is told another size.
void set_options() {
  [[maybe_unused]] static const bool once = [] {
    return jsc_options_set_boolean("usePollingTraps", TRUE) &&
           jsc_options_set_boolean("useTailCalls", FALSE) &&
           jsc_options_set_boolean("useFTLJIT", FALSE) &&
           jsc_options_set_size("forceRAMSize", kSupposedMemory);
  }();
}

// The heap that the engines of a thread share. Bundles that one of them has parsed cost the next
// one a tenth of the time.
std::shared_ptr<const OpaqueJSContextGroup> group_of_thread() {
  set_options();
  thread_local const std::shared_ptr<const OpaqueJSContextGroup> group(
      JSContextGroupCreate(), [](JSContextGroupRef ended) { JSContextGroupRelease(ended); });
  return group;
}

std::string in_seconds(double seconds) {
  std::ostringstream text;
  text << seconds << " s";
  return text.str();
}

}  // namespace

Engine::Engine(double time_limit)
    : group_(group_of_thread()),
      context_(JSGlobalContextCreateInGroup(group_.get(), nullptr)),
      time_limit_(time_limit) {
  load(std::string("{") + fixed_surroundings + "}", "surroundings.js");
}

Engine::~Engine() {
  JSGlobalContextRelease(context_);
}

void Engine::load(const std::string& source, const std::string& name) {
  const auto loaded = evaluate(source, name);
  if (!loaded) throw std::runtime_error(name + ": " + describe(loaded.error()).message);
}

tl::expected<std::string, ScriptError> Engine::call(const std::string& function,
                                                    const std::vector<std::string>& arguments) {
  JSObjectRef global = JSContextGetGlobalObject(context_);
  JSObjectRef callee = object_in(context_, property(context_, global, function));
  if (callee == nullptr) throw std::logic_error("no bundle defines " + function + "()");
  // on the stack, where the garbage collector sees them; it does not look into a std::vector
  std::array<JSValueRef, max_arguments> values{};
  if (arguments.size() > values.size()) throw std::logic_error(function + ": too many arguments");
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    values[i] = make_text(context_, arguments[i]);
  }
  const auto result = call(callee, std::span(values).first(arguments.size()));
  if (!result) return tl::unexpected(describe(result.error()));
  return text_of(context_, *result);
}

tl::expected<JSValueRef, Engine::Thrown> Engine::evaluate(const std::string& source,
                                                          const std::string& url) {
  JSValueRef exception = nullptr;
  arm();
  JSValueRef result =
      JSEvaluateScript(context_, JsString(source), nullptr, JsString(url), 1, &exception);
  return outcome(result, exception);
}

tl::expected<JSValueRef, Engine::Thrown> Engine::call(JSObjectRef function,
                                                      std::span<const JSValueRef> arguments) {
  JSValueRef exception = nullptr;
  arm();
  JSValueRef result = JSObjectCallAsFunction(context_, function, nullptr, arguments.size(),
                                             arguments.data(), &exception);
  return outcome(result, exception);
}

// The limit holds for one call: each further call sets it again.
void Engine::arm() {
  expired_ = false;
  const auto expire = [](JSContextRef, void* data) {
    *static_cast<bool*>(data) = true;
    return true;
  };
  JSContextGroupSetExecutionTimeLimit(group_.get(), time_limit_, expire, &expired_);
}

tl::expected<JSValueRef, Engine::Thrown> Engine::outcome(JSValueRef result,
                                                         JSValueRef exception) const {
  if (expired_) return tl::unexpected(Thrown{});
  if (exception != nullptr) return tl::unexpected(Thrown{exception});
  return result;
}

ScriptError Engine::describe(const Thrown& thrown) const {
  ScriptError error;
  if (thrown.exception == nullptr) {
    error.id = "E-script-time";
    error.message = "ran for more than " + in_seconds(time_limit_);
    error.cure = "look for a loop that never ends";
    return error;
  }
  return explain(read_exception(context_, thrown.exception, ""), {});
}

}  // namespace mjcourse
