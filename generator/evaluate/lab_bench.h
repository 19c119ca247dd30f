// The bench that a lab is rehearsed on: the lab, the tools, and where its mistakes go.
#pragma once

#include <string>
#include <utility>

#include "evaluate/script_place.h"
#include "evaluate/workshop.h"

namespace mjcourse {

class LabBench {
 public:
  LabBench(const Lab& lab, const Lesson& lesson, Workshop& workshop, Diagnostics& diagnostics)
      : lab_(lab), lesson_(lesson), workshop_(workshop), diagnostics_(diagnostics) {}

  const Lab& lab() const { return lab_; }
  Workshop& workshop() const { return workshop_; }

  std::optional<Simulation> simulate(const LocatedText& model) const {
    return workshop_.simulate(model, *lesson_.source, diagnostics_);
  }

  // Both report, and give false.
  bool error(std::string id, Span span, std::string message, std::string cure = "") const {
    diagnostics_.push_back(error_at(place_of(*lesson_.source, span), std::move(id),
                                    std::move(message), std::move(cure)));
    return false;
  }
  // `solution` names the model where it is not the lab's own.
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
  const Lab& lab_;
  const Lesson& lesson_;
  Workshop& workshop_;
  Diagnostics& diagnostics_;
};

}  // namespace mjcourse
