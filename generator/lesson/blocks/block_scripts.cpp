#include "lesson/blocks/block_scripts.h"

#include "base/any_of.h"

namespace mjcourse {
namespace {

class Collector {
 public:
  std::vector<const LocatedText*> run(const Block& block) {
    std::visit(*this, block);
    return std::move(scripts_);
  }

  void operator()(const Lab& lab) {
    for (const Lab::Control& control : lab.controls) std::visit(*this, control);
    for (const Lab::Readout& readout : lab.readouts) add(readout.expression);
    for (const Lab::Plot& plot : lab.plots) {
      for (const Lab::Readout& trace : plot.traces) add(trace.expression);
    }
    if (lab.predict) add(lab.predict->run, lab.predict->value);
    if (lab.goal) add(lab.goal->done, lab.goal->solution_run);
    if (lab.ghost) add(lab.ghost->run);
    for (const Lab::Task& task : lab.tasks) add(task.value);
  }
  void operator()(const Lab::Button& button) { add(button.run); }
  void operator()(const Lab::Slider& slider) { add(slider.bind); }
  void operator()(const Lab::Toggle& toggle) { add(toggle.on, toggle.off); }
  void operator()(const Lab::Select& select) {
    for (const Lab::Select::Option& option : select.options) add(option.run);
  }

  void operator()(const InlineValue& value) { add(value.expression); }
  void operator()(const Figure& figure) { add(figure.run); }
  void operator()(const Quiz& quiz) {
    for (const Question& question : quiz.questions) {
      for (const Proof& proof : question.proofs) (*this)(proof);
    }
  }
  void operator()(const Proof& proof) {
    add(proof.run, proof.value);
    for (const LocatedText& option : proof.options) add(option);
    for (const LocatedText& value : proof.values) add(value);
  }
  template <AnyOf<Lab::Keyframe, Math, TermUse, Example, Unchecked, Snippet, Commands, ModelExcerpt,
                  InlineModel, Output, Image, Io, Callout, Plot, Demo, Shown>
                Other>
  void operator()(const Other&) {}

 private:
  template <typename... Texts>
  void add(const Texts&... texts) {
    for (const LocatedText* text : {&texts...}) {
      if (!text->text.empty()) scripts_.push_back(text);
    }
  }

  std::vector<const LocatedText*> scripts_;
};

}  // namespace

std::vector<const LocatedText*> scripts_of(const Block& block) {
  return Collector().run(block);
}

}  // namespace mjcourse
