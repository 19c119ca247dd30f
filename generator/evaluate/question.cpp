#include "evaluate/question.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "evaluate/script_place.h"
#include "physics/described_model.h"
#include "script/world.h"

namespace mjcourse {
namespace {

constexpr double kScriptLimit = 5;  // seconds of CPU time for one script

std::string number_text(double value) {
  std::ostringstream text;
  text.precision(10);
  text << value;
  return text.str();
}

int count_of(const Proof& proof, const std::string& kind) {
  const auto found = proof.joints.find(kind);
  return found == proof.joints.end() ? 0 : found->second;
}

// "7 hinge, 2 slide and 3 free joints", "1 ball joint"
std::string joints_text(const Proof& proof) {
  std::string text;
  std::size_t left = proof.joints.size();
  int joints = 0;
  for (const char* kind : {"hinge", "slide", "ball", "free"}) {
    const int count = count_of(proof, kind);
    if (count == 0) continue;
    joints += count;
    --left;
    text += std::to_string(count) + " " + kind;
    if (left > 0) text += left > 1 ? ", " : " and ";
  }
  if (joints == 0) return "no joints";
  return text + (joints == 1 ? " joint" : " joints");
}

std::string built_text(const Proof& proof) {
  if (!proof.model.text.empty()) return proof.model.text;
  return proof.mjcf.text.empty() ? joints_text(proof) : "the model in the question";
}

class Examiner {
 public:
  Examiner(const Question& question, const Lesson& lesson, Workshop& workshop,
           Diagnostics& diagnostics)
      : question_(question), lesson_(lesson), workshop_(workshop), diagnostics_(diagnostics) {}

  std::optional<QuestionResult> run();

 private:
  std::optional<Simulation> build(const Proof& proof);
  bool prove(const Proof& proof, QuestionResult& result);
  bool prove_value(const Proof& proof, QuestionResult& result);
  bool prove_options(const Proof& proof, QuestionResult& result);
  bool script_error(const ScriptError& error, const Proof& proof, const LocatedText& value) {
    const LocatedText& script = error.in_value || proof.run.text.empty() ? value : proof.run;
    diagnostics_.push_back(script_diagnostic(error, script, *lesson_.source));
    return false;
  }
  void wrong(std::string id, Span span, std::string message, const LocatedText& proved_at,
             const std::string& proof_text) {
    Note proof{proof_text, place_of(*lesson_.source, proved_at.span())};
    // Several proofs that find the same other answer are one mistake.
    Diagnostic* last = diagnostics_.empty() ? nullptr : &diagnostics_.back();
    if (reported_ && last != nullptr && last->id == id && last->message == message) {
      last->notes.push_back(std::move(proof));
      return;
    }
    Diagnostic found = error_at(place_of(*lesson_.source, span), std::move(id), std::move(message));
    found.notes.push_back(std::move(proof));
    diagnostics_.push_back(std::move(found));
    reported_ = true;
  }

  const Question& question_;
  const Lesson& lesson_;
  Workshop& workshop_;
  Diagnostics& diagnostics_;
  bool reported_ = false;  // a wrong answer of this question
};

std::optional<Simulation> Examiner::build(const Proof& proof) {
  if (!proof.model.text.empty()) {
    return workshop_.simulate(proof.model, *lesson_.source, diagnostics_);
  }
  if (!proof.mjcf.text.empty()) {
    return workshop_.simulate(proof.mjcf, *lesson_.source, diagnostics_);
  }
  const LocatedText described{described_mjcf({count_of(proof, "hinge"), count_of(proof, "slide"),
                                              count_of(proof, "ball"), count_of(proof, "free")}),
                              {}};
  return workshop_.simulate(described, *lesson_.source, diagnostics_);
}

bool Examiner::prove_value(const Proof& proof, QuestionResult& result) {
  std::optional<Simulation> simulation = build(proof);
  if (!simulation) return false;
  World world(workshop_.world_bundle(), *simulation, kScriptLimit);
  const auto value = world.number(Program{proof.run.text, proof.seconds, proof.value.text});
  if (!value) return script_error(value.error(), proof, proof.value);
  const double expected = proof.equals.value_or(question_.answer);
  // Binary doubles hold few decimals exactly: a tolerance of 0 still allows for that.
  const double allowed = question_.tolerance + 1e-12 * std::max(1.0, std::abs(*value));
  if (!(std::abs(*value - expected) <= allowed)) {
    const std::string found =
        "`" + proof.value.text + "` is " + number_text(*value) + " for " + built_text(proof);
    if (proof.equals) {
      wrong("E-proof-value", proof.span,
            "the proof expects " + number_text(expected) + ", but finds " + number_text(*value),
            proof.value, found);
    } else {
      wrong("E-quiz-answer", question_.answer_span,
            "the answer is given as " + number_text(expected) + ", but the build finds " +
                number_text(*value),
            proof.value, found);
    }
    return false;
  }
  result.proofs.push_back({built_text(proof), proof.value.text, number_text(*value)});
  return true;
}

bool Examiner::prove_options(const Proof& proof, QuestionResult& result) {
  std::vector<std::size_t> holding;
  for (std::size_t i = 0; i < proof.options.size(); ++i) {
    std::optional<Simulation> simulation = build(proof);  // a fresh state for each option
    if (!simulation) return false;
    World world(workshop_.world_bundle(), *simulation, kScriptLimit);
    const auto holds = world.truth(Program{proof.run.text, proof.seconds, proof.options[i].text});
    if (!holds) return script_error(holds.error(), proof, proof.options[i]);
    if (*holds) holding.push_back(i);
  }
  const auto option_text = [&](std::size_t i) {
    return std::to_string(i) + " (\"" + plain_text(question_.options[i].get()) + "\")";
  };
  const auto answer = static_cast<std::size_t>(question_.answer);
  if (holding.size() == 1 && holding[0] == answer) {
    result.proofs.push_back({built_text(proof), "", plain_text(question_.options[answer].get())});
    return true;
  }
  std::string found = holding.empty() ? "no option" : "";
  for (std::size_t i = 0; i < holding.size(); ++i) {
    found += (i == 0 ? "" : " and ") + option_text(holding[i]);
  }
  wrong("E-quiz-answer", question_.answer_span,
        "the answer is given as option " + option_text(answer) + ", but the build finds " + found,
        proof.options[holding.empty() ? answer : holding[0]],
        holding.empty() ? "this does not hold for " + built_text(proof)
                        : "this holds for " + built_text(proof));
  return false;
}

bool Examiner::prove(const Proof& proof, QuestionResult& result) {
  if (!proof.because.text.empty()) {
    result.because = proof.because.text;
    return true;
  }
  const bool proved =
      proof.options.empty() ? prove_value(proof, result) : prove_options(proof, result);
  // What is held against `equals` says nothing of the answer.
  result.proved = result.proved || (proved && !proof.equals);
  return proved;
}

std::optional<QuestionResult> Examiner::run() {
  QuestionResult result;
  bool good = true;
  for (const Proof& proof : question_.proofs) good = prove(proof, result) && good;
  return good ? std::optional(result) : std::nullopt;
}

}  // namespace

std::optional<QuestionResult> evaluate_question(const Question& question, const Lesson& lesson,
                                                Workshop& workshop, Diagnostics& diagnostics) {
  return Examiner(question, lesson, workshop, diagnostics).run();
}

}  // namespace mjcourse
