// Proofs that prove nothing: of an expression that is the same whatever the model does, and of
// options that the proof cannot tell apart.
// Tested by tests/courses/quiz.
#pragma once

#include <functional>
#include <optional>

#include "evaluate/context/worker_context.h"

namespace mjcourse {

// W-proof-constant and W-proof-indistinct, of a proof that holds. `build` makes what it asks anew.
void warn_of_weak_proof(const Proof& proof, const Question& question, const Lesson& lesson,
                        const std::function<std::optional<Simulation>()>& build,
                        WorkerContext& worker_context, Diagnostics& diagnostics);

}  // namespace mjcourse
