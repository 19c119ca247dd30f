// Engine: JavaScriptCore, the one script engine of the generator.
//
// Enter with load(), which runs a trusted bundle of ours, then call(), which gives strings to one
// of its functions and takes a string back. Every call has a time limit, after which it ends and
// the engine is as good as before. Builds are reproducible: `Date` stands still, and `Math.random`
// draws the same numbers in every engine.
//
// An engine is used by the thread that made it. JavaScriptCore installs handlers for SIGSEGV,
// SIGBUS and SIGUSR1 when the first engine is made, and reserves more than 4 GB of address space
// (not memory), so the process must not run under RLIMIT_AS.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "script/javascriptcore.h"
#include "script/script_error.h"

namespace mjcourse {

class Engine {
 public:
  // `time_limit` is in seconds of CPU time, for each call.
  explicit Engine(double time_limit = 10);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  // Run `source`, which sets globals. Throws std::runtime_error when it fails: a bundle is ours.
  void load(const std::string& source, const std::string& name);

  static constexpr std::size_t max_arguments = 8;

  // The text that the global `function` returns. Throws std::logic_error when no bundle defines it.
  tl::expected<std::string, ScriptError> call(const std::string& function,
                                              const std::vector<std::string>& arguments);

  // The rest is for classes that bind C++ to scripts. A value lives as long as a JavaScript
  // variable, the C++ stack or a Protected (js_value.h) holds it; a container does not.

  JSGlobalContextRef context() const { return context_; }

  // What a script left behind that ended early: its exception, or nothing after the time limit.
  struct Thrown {
    JSValueRef exception = nullptr;
  };
  tl::expected<JSValueRef, Thrown> evaluate(const std::string& source, const std::string& url);
  tl::expected<JSValueRef, Thrown> call(JSObjectRef function,
                                        std::span<const JSValueRef> arguments = {});

  // `thrown` in words, without a place.
  ScriptError describe(const Thrown& thrown) const;

 private:
  void arm();
  tl::expected<JSValueRef, Thrown> outcome(JSValueRef result, JSValueRef exception) const;

  std::shared_ptr<const OpaqueJSContextGroup> group_;
  JSGlobalContextRef context_;
  double time_limit_;
  bool expired_ = false;  // set by the callback of the time limit
};

}  // namespace mjcourse
