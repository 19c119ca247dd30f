#include "evaluate/answers/question.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>

#include "evaluate/answers/proof_text.h"
#include "evaluate/answers/weak_proof.h"
#include "evaluate/context/script_place.h"
#include "physics/described_model.h"
#include "script/world.h"

namespace mjcourse {
namespace {

class Examiner {
 public:
  Examiner(const Question& question, const Lesson& lesson, WorkerContext& worker_context,
           Diagnostics& diagnostics)
      : question_(question),
        lesson_(lesson),
        worker_context_(worker_context),
        diagnostics_(diagnostics) {}

  std::optional<QuestionResult> run();

 private:
  std::optional<Simulation> build(const Proof& proof);
  bool prove(const Proof& proof, QuestionResult& result);
  std::optional<double> find_value(const Proof& proof);
  bool prove_value(const Proof& proof, QuestionResult& result);
  bool prove_options(const Proof& proof, QuestionResult& result);
  bool prove_order(const Proof& proof, QuestionResult& result);
  std::optional<std::vector<double>> find_values(const Proof& proof);
  std::string option_text(std::size_t index) const {
    return "\"" + plain_text(question_.options[index].text.get()) + "\"";
  }
  std::string options_text(const std::vector<std::size_t>& indices) const;
  std::string order_text(const std::vector<std::size_t>& order) const;
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
  WorkerContext& worker_context_;
  Diagnostics& diagnostics_;
  bool reported_ = false;  // a wrong answer of this question
};

std::optional<Simulation> Examiner::build(const Proof& proof) {
  if (!proof.model.text.empty()) {
    return worker_context_.simulate(proof.model, *lesson_.source, diagnostics_);
  }
  if (!proof.mjcf.text.empty()) {
    return worker_context_.simulate(proof.mjcf, *lesson_.source, diagnostics_);
  }
  const LocatedText described{
      described_mjcf({joint_count(proof, "hinge"), joint_count(proof, "slide"),
                      joint_count(proof, "ball"), joint_count(proof, "free")}),
      {}};
  return worker_context_.simulate(described, *lesson_.source, diagnostics_);
}

std::optional<double> Examiner::find_value(const Proof& proof) {
  if (!proof.example.text.empty()) {
    const auto reported = worker_context_.reports_of(proof.example.text)
                              .find(proof.example, proof.value, *lesson_.source, diagnostics_);
    if (!reported) return std::nullopt;
    if (const auto number = as_double(*reported)) return number;
    diagnostics_.push_back(error_at(place_of(*lesson_.source, proof.value.span()), "E-proof-value",
                                    "the result `" + proof.value.text + "` is not a number",
                                    "report the number by itself"));
    return std::nullopt;
  }
  std::optional<Simulation> simulation = build(proof);
  if (!simulation) return std::nullopt;
  World world(worker_context_.world_bundle(), *simulation);
  const auto value = world.number(Program{proof.run.text, proof.seconds, proof.value.text});
  if (value) return *value;
  script_error(value.error(), proof, proof.value);
  return std::nullopt;
}

bool Examiner::prove_value(const Proof& proof, QuestionResult& result) {
  const std::optional<double> value = find_value(proof);
  if (!value) return false;
  const double expected = proof.equals.value_or(question_.answer);
  if (!question_.tolerance.allows(*value, expected)) {
    const std::string stated = number_text(expected, *value), real = number_text(*value, expected);
    const std::string found = "`" + proof.value.text + "` is " + real + " for " + built_text(proof);
    if (proof.equals) {
      wrong("E-proof-value", proof.span, "the proof expects " + stated + ", but finds " + real,
            proof.value, found);
    } else {
      wrong("E-quiz-answer", question_.answer_span,
            "the answer is given as " + stated + ", but the build finds " + real, proof.value,
            found);
    }
    return false;
  }
  result.proofs.push_back({built_model(proof), proof.value.text, number_text(*value)});
  return true;
}

// `option 1 ("two")`, `options 0 ("one") and 2 ("three")`, `no option`
std::string Examiner::options_text(const std::vector<std::size_t>& indices) const {
  std::vector<std::string> words;
  for (const std::size_t i : indices) {
    words.push_back(std::to_string(i) + " (" + option_text(i) + ")");
  }
  return words.empty() ? "no option" : listed(words);
}

bool Examiner::prove_options(const Proof& proof, QuestionResult& result) {
  std::vector<std::size_t> holding;
  for (std::size_t i = 0; i < proof.options.size(); ++i) {
    std::optional<Simulation> simulation = build(proof);  // a fresh state for each option
    if (!simulation) return false;
    World world(worker_context_.world_bundle(), *simulation);
    const auto holds = world.truth(Program{proof.run.text, proof.seconds, proof.options[i].text});
    if (!holds) return script_error(holds.error(), proof, proof.options[i]);
    if (*holds) holding.push_back(i);
  }
  const std::vector<std::size_t>& right = question_.right;
  if (holding == right) {
    result.proofs.push_back({built_model(proof), "", options_text(right)});
    return true;
  }
  // One that holds and should not tells more than one that should and does not.
  std::vector<std::size_t> extra, missing;
  std::set_difference(holding.begin(), holding.end(), right.begin(), right.end(),
                      std::back_inserter(extra));
  std::set_difference(right.begin(), right.end(), holding.begin(), holding.end(),
                      std::back_inserter(missing));
  wrong("E-quiz-answer", question_.answer_span,
        std::string("the answer is given as option") + (right.size() == 1 ? " " : "s ") +
            options_text(right) + ", but the build finds " + options_text(holding),
        proof.options[extra.empty() ? missing[0] : extra[0]],
        (extra.empty() ? "this does not hold for " : "this holds for ") + built_text(proof));
  return false;
}

std::string Examiner::order_text(const std::vector<std::size_t>& order) const {
  std::string text;
  for (const std::size_t i : order) text += (text.empty() ? "" : ", ") + option_text(i);
  return text;
}

// The number of each item.
std::optional<std::vector<double>> Examiner::find_values(const Proof& proof) {
  std::vector<double> values;
  for (const LocatedText& expression : proof.values) {
    std::optional<Simulation> simulation = build(proof);  // a fresh state for each item
    if (!simulation) return std::nullopt;
    World world(worker_context_.world_bundle(), *simulation);
    const auto value = world.number(Program{proof.run.text, proof.seconds, expression.text});
    if (!value) {
      script_error(value.error(), proof, expression);
      return std::nullopt;
    }
    values.push_back(*value);
  }
  return values;
}

bool Examiner::prove_order(const Proof& proof, QuestionResult& result) {
  const std::optional<std::vector<double>> numbers = find_values(proof);
  if (!numbers) return false;
  const std::vector<double>& values = *numbers;
  std::vector<std::size_t> given(values.size());
  std::iota(given.begin(), given.end(), 0);
  std::vector<std::size_t> found = given;
  std::stable_sort(found.begin(), found.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<std::string> texts;
  for (const std::size_t i : found) texts.push_back(number_text(values[i]));

  const std::string but = "the order is given as " + order_text(given) + ", but the build finds ";
  const double apart = rounding(values);
  for (std::size_t place = 1; place < found.size(); ++place) {
    const std::size_t before = found[place - 1], i = found[place];
    if (values[i] - values[before] > apart) continue;
    wrong("E-quiz-answer", question_.options[i].span,
          but + option_text(before) + " and " + option_text(i) + " equal", proof.values[i],
          "both are " + texts[place] + " for " + built_text(proof));
    return false;
  }
  const auto misplaced = std::mismatch(given.begin(), given.end(), found.begin()).first;
  if (misplaced != given.end()) {
    wrong("E-quiz-answer", question_.options[*misplaced].span, but + order_text(found),
          proof.values[*misplaced],
          "in that order they are " + listed(texts) + " for " + built_text(proof));
    return false;
  }
  std::string rising;
  for (const std::string& text : texts) rising += (rising.empty() ? "" : " < ") + text;
  result.proofs.push_back({built_model(proof), "", rising});
  return true;
}

bool Examiner::prove(const Proof& proof, QuestionResult& result) {
  if (!proof.because.text.empty()) {
    result.because = proof.because.text;
    return true;
  }
  const bool proved = !proof.options.empty()  ? prove_options(proof, result)
                      : !proof.values.empty() ? prove_order(proof, result)
                                              : prove_value(proof, result);
  // What is held against `equals` says nothing of the answer.
  result.proved = result.proved || (proved && !proof.equals);
  if (proved) {
    const auto anew = [&] { return build(proof); };
    warn_of_weak_proof(proof, question_, lesson_, anew, worker_context_, diagnostics_);
  }
  return proved;
}

std::optional<QuestionResult> Examiner::run() {
  QuestionResult result;
  bool good = true;
  result.by_program = std::all_of(question_.proofs.begin(), question_.proofs.end(),
                                  [](const Proof& proof) { return !proof.example.text.empty(); });
  for (const Proof& proof : question_.proofs) good = prove(proof, result) && good;
  return good ? std::optional(result) : std::nullopt;
}

}  // namespace

std::optional<QuestionResult> evaluate_question(const Question& question, const Lesson& lesson,
                                                WorkerContext& worker_context,
                                                Diagnostics& diagnostics) {
  return Examiner(question, lesson, worker_context, diagnostics).run();
}

}  // namespace mjcourse
