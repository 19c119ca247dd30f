#include "lesson/blocks/block_scripts.h"

#include "base/any_of.h"

namespace mjcourse {
namespace {

class Collector {
 public:
  std::vector<BlockScript> take() { return std::move(scripts_); }

  void operator()(const Lab& lab) {
    add(lab.define, ScriptKind::definitions);
    for (const Lab::Control& control : lab.controls) std::visit(*this, control);
    for (const Lab::Readout& readout : lab.readouts) add_values(readout.expression);
    for (const Lab::Plot& plot : lab.plots) {
      for (const Lab::Readout& trace : plot.traces) add_values(trace.expression);
    }
    if (lab.predict) {
      add_scripts(lab.predict->run);
      add_values(lab.predict->value);
    }
    if (lab.goal) {
      add_values(lab.goal->done);
      add_scripts(lab.goal->solution_run);
    }
    if (lab.ghost) add_scripts(lab.ghost->run);
    for (const Lab::Task& task : lab.tasks) add_values(task.value);
  }
  void operator()(const Lab::Button& button) { add_scripts(button.run); }
  void operator()(const Lab::Slider& slider) { add(slider.bind, ScriptKind::assignment); }
  void operator()(const Lab::Toggle& toggle) { add_scripts(toggle.on, toggle.off); }
  void operator()(const Lab::Select& select) {
    for (const Lab::Select::Option& option : select.options) add_scripts(option.run);
  }

  void operator()(const InlineValue& value) { add_values(value.expression); }
  void operator()(const Figure& figure) { add_scripts(figure.run); }
  void operator()(const Quiz& quiz) {
    for (const Question& question : quiz.questions) {
      for (const Proof& proof : question.proofs) (*this)(proof);
    }
  }
  void operator()(const Proof& proof) {
    add_scripts(proof.run);
    add_values(proof.value);
    for (const LocatedText& option : proof.options) add_values(option);
    for (const LocatedText& value : proof.values) add_values(value);
  }
  template <AnyOf<Lab::Keyframe, Math, TermUse, Example, Exercise, Unchecked, Snippet, Commands,
                  ModelExcerpt, InlineModel, Output, Image, Io, Callout, Plot, Demo, Shown>
                Other>
  void operator()(const Other&) {}

 private:
  void add(const LocatedText& text, ScriptKind kind) {
    if (!text.text.empty()) scripts_.push_back({&text, kind});
  }
  template <typename... Texts>
  void add_scripts(const Texts&... texts) {
    (add(texts, ScriptKind::script), ...);
  }
  void add_values(const LocatedText& text) { add(text, ScriptKind::value); }

  std::vector<BlockScript> scripts_;
};

}  // namespace

std::vector<BlockScript> scripts_of(const Block& block) {
  Collector collector;
  std::visit(collector, block);
  return collector.take();
}

std::vector<BlockScript> scripts_of(const Lab& lab) {
  Collector collector;
  collector(lab);
  return collector.take();
}

}  // namespace mjcourse
