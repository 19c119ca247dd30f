#include "evaluate/answers/weak_proof.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "evaluate/answers/proof_text.h"
#include "lesson/syntax/reading.h"
#include "script/world.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// A vector, a quaternion, a frame. Single numbers are often equal and mean different things, as
// are lists of nothing but 0.
bool is_list_of_numbers(const json& value) {
  return value.is_array() && value.size() >= 3 &&
         std::ranges::all_of(value, [](const json& one) { return one.is_number(); }) &&
         std::ranges::any_of(value, [](const json& one) { return one != 0; });
}

class WeakProof {
 public:
  WeakProof(const Proof& proof, const Question& question, const Lesson& lesson,
            const std::function<std::optional<Simulation>()>& build, WorkerContext& worker_context,
            Diagnostics& diagnostics)
      : proof_(proof),
        question_(question),
        build_(build),
        worker_context_(worker_context),
        reading_(*lesson.source, diagnostics) {}

  void run() {
    if (!proof_.example.text.empty() || !proof_.because.text.empty()) return;
    if (const LocatedText* constant = find_constant()) return tell_constant(*constant);
    if (proof_.options.empty()) return;
    const std::size_t right = question_.right.size();
    if (right == 0 || right == proof_.options.size()) {
      reading_.warning("W-proof-indistinct", question_.answer_span,
                       std::string(right == 0 ? "no option holds" : "every option holds") +
                           ", so the proof tells none of them from the others",
                       "add an option that is wrong in the same model, and one that is right");
      return;
    }
    look_for_twins();
  }

 private:
  bool asks_world(const LocatedText& expression) const {
    const auto asked = worker_context_.script_guard().ask(proof_.run.text, expression.text,
                                                          worker_context_.script_names());
    return !asked || asked->world;
  }

  // Wrong options and single items may be what no model has; the right ones may not.
  const LocatedText* find_constant() const {
    if (!proof_.value.text.empty()) return asks_world(proof_.value) ? nullptr : &proof_.value;
    for (const std::size_t right : question_.right) {
      if (right < proof_.options.size() && !asks_world(proof_.options[right])) {
        return &proof_.options[right];
      }
    }
    const auto& all = proof_.options.empty() ? proof_.values : proof_.options;
    const bool any = std::ranges::any_of(all, [&](const auto& one) { return asks_world(one); });
    return any ? nullptr : &all.front();
  }

  void tell_constant(const LocatedText& expression) {
    reading_.warning("W-proof-constant", expression.span(),
                     "`" + expression.text +
                         "` asks neither the model nor its data: it proves the same of any model",
                     "compute it from them, as `data.qpos[0]` does; or say why nothing can be "
                     "built: `{\"because\": \"…\"}`");
  }

  // Wrong options that put the same list into the same function: `heldIn(world)` and
  // `heldIn(parent)`, where both frames are one.
  void look_for_twins() {
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> twins;
    for (std::size_t i = 0; i < proof_.options.size(); ++i) {
      if (std::ranges::find(question_.right, i) != question_.right.end()) continue;
      const auto asked = worker_context_.script_guard().ask(proof_.run.text, proof_.options[i].text,
                                                            worker_context_.script_names());
      if (!asked || asked->callee.empty()) continue;
      const std::optional<std::string> values = values_of(*asked);
      if (values) twins[{asked->callee, *values}].push_back(i);
    }
    for (const auto& [asked, options] : twins) {
      if (options.size() > 1) tell_twins(asked.first, asked.second, options);
    }
  }

  // JSON, as the option's own run of the script finds them; nothing where they are no list.
  std::optional<std::string> values_of(const ExpressionText& asked) const {
    std::optional<Simulation> simulation = build_();
    if (!simulation) return std::nullopt;
    World world(worker_context_.world_bundle(), *simulation);
    const std::string plain =
        "(key, value) => typeof value === 'object' && value !== null && value.length >= 0 ? "
        "Array.from(value) : value";
    const auto text = world.value(Program{proof_.run.text, proof_.seconds,
                                          "JSON.stringify([" + asked.values + "], " + plain + ")"});
    if (!text || !text->is_string()) return std::nullopt;
    const json values = json::parse(text->get<std::string>(), nullptr, false);
    if (!values.is_array() || !std::ranges::any_of(values, is_list_of_numbers)) {
      return std::nullopt;
    }
    const std::string list = values.dump();
    return list.substr(1, list.size() - 2);
  }

  void tell_twins(const std::string& callee, const std::string& values,
                  const std::vector<std::size_t>& options) {
    std::vector<std::string> numbers;
    for (const std::size_t i : options) numbers.push_back(std::to_string(i));
    reading_.warning("W-proof-indistinct", proof_.options[options[1]].span(),
                     "options " + listed(numbers) + " are one and the same here: each asks `" +
                         callee + "` about " + values,
                     "let the model tell them apart, for instance by a body with a `quat` of its "
                     "own");
  }

  const Proof& proof_;
  const Question& question_;
  const std::function<std::optional<Simulation>()>& build_;
  WorkerContext& worker_context_;
  Reading reading_;
};

}  // namespace

void warn_of_weak_proof(const Proof& proof, const Question& question, const Lesson& lesson,
                        const std::function<std::optional<Simulation>()>& build,
                        WorkerContext& worker_context, Diagnostics& diagnostics) {
  WeakProof(proof, question, lesson, build, worker_context, diagnostics).run();
}

}  // namespace mjcourse
