// BlockContext: the context in which one block is evaluated: its lesson, the thread's tools, and
// its diagnostics.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "evaluate/context/script_place.h"
#include "evaluate/context/worker_context.h"

namespace mjcourse {

class BlockContext {
 public:
  BlockContext(const Lesson& lesson, WorkerContext& worker_context, Diagnostics& diagnostics)
      : lesson_(lesson), worker_context_(worker_context), diagnostics_(diagnostics) {}

  const Lesson& lesson() const { return lesson_; }
  WorkerContext& worker_context() const { return worker_context_; }
  Diagnostics& diagnostics() const { return diagnostics_; }

  std::optional<Simulation> simulate(const LocatedText& model) const {
    return worker_context_.simulate(model, *lesson_.source, diagnostics_);
  }

  // Both report, and give false.
  bool error(std::string id, Span span, std::string message, std::string cure = "") const {
    diagnostics_.push_back(error_at(place_of(*lesson_.source, span), std::move(id),
                                    std::move(message), std::move(cure)));
    return false;
  }
  // `solution` names the model where it is not the block's own.
  bool error(const ScriptError& error, const LocatedText& script,
             const LocatedText* solution = nullptr) const {
    diagnostics_.push_back(script_diagnostic(error, script, *lesson_.source));
    if (solution != nullptr) {
      diagnostics_.back().notes.push_back(
          {"the model is the solution's", place_of(*lesson_.source, solution->span())});
    }
    return false;
  }

 private:
  const Lesson& lesson_;
  WorkerContext& worker_context_;
  Diagnostics& diagnostics_;
};

}  // namespace mjcourse
