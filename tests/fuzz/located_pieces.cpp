#include "located_pieces.h"

namespace mjcourse {
namespace {

class Collector {
 public:
  void take(const Math& math) { text(math.tex); }
  void take(const InlineValue& value) { texts({&value.source, &value.expression, &value.format}); }
  void take(const TermUse& term) { text(term.name); }
  void take(const Example& example) {
    text(example.file);
    if (example.region) text(*example.region);
    body(example.code);
    span(example.span);
  }
  void take(const Exercise& exercise) {
    take(exercise.program);
    if (exercise.hidden) text(*exercise.hidden);
    span(exercise.span);
  }
  void take(const Unchecked& unchecked) {
    body(unchecked.code);
    span(unchecked.span);
  }
  void take(const Snippet& snippet) {
    text(snippet.model);
    text(snippet.code);
    span(snippet.span);
  }
  void take(const Commands& commands) {
    body(commands.code);
    for (const LocatedText& file : commands.files) text(file);
    span(commands.span);
  }
  void take(const ModelExcerpt& excerpt) {
    text(excerpt.model);
    body(excerpt.text);
    span(excerpt.span);
  }
  void take(const InlineModel& model) {
    body(model.text);
    span(model.span);
  }
  void take(const Output& output) {
    body(output.text);
    span(output.span);
  }
  void take(const Image& image) { text(image.file); }
  void take(const Io&) {}
  void take(const Callout& callout) { span(callout.span); }
  void take(const Lab& lab);
  void take(const Figure& figure);
  void take(const Plot& plot) {
    texts({&plot.example, &plot.table});
    tree(plot.tree);
    span(plot.span);
  }
  void take(const Quiz& quiz) {
    for (const Question& question : quiz.questions) take_question(question);
  }
  void take(const Demo&) {}
  void take(const Shown&) {}

  LocatedPieces pieces() { return std::move(pieces_); }

 private:
  void text(const LocatedText& text) { pieces_.texts.push_back(&text); }
  void texts(std::initializer_list<const LocatedText*> all) {
    pieces_.texts.insert(pieces_.texts.end(), all);
  }
  void body(const LocatedText& body) {
    pieces_.texts.push_back(&body);
    pieces_.bodies.push_back(&body);
  }
  void span(Span span) { pieces_.spans.push_back(span); }

  void control(const Lab::Button& button) { texts({&button.label, &button.run}); }
  void control(const Lab::Slider& slider) { texts({&slider.label, &slider.bind}); }
  void control(const Lab::Toggle& toggle) { texts({&toggle.label, &toggle.on, &toggle.off}); }
  void control(const Lab::Select& select) {
    text(select.label);
    for (const auto& option : select.options) texts({&option.label, &option.run});
  }
  void control(const Lab::Keyframe& keyframe) { texts({&keyframe.label, &keyframe.key}); }
  void readouts(const std::vector<Lab::Readout>& readouts) {
    for (const Lab::Readout& readout : readouts) texts({&readout.label, &readout.expression});
  }
  void take_question(const Question& question);
  void tree(const JsonValue& value);

  LocatedPieces pieces_;
};

void Collector::take(const Lab& lab) {
  texts({&lab.model, &lab.pin});
  for (const LocatedText& toggle : lab.toggles) text(toggle);
  for (const Lab::Overlay& overlay : lab.overlays) text(overlay.name);
  for (const Lab::Control& one : lab.controls) {
    std::visit([this](const auto& of_kind) { control(of_kind); }, one);
  }
  readouts(lab.readouts);
  for (const Lab::Plot& plot : lab.plots) readouts(plot.traces);
  if (lab.predict) texts({&lab.predict->run, &lab.predict->value});
  if (lab.goal) {
    texts({&lab.goal->done, &lab.goal->solution_run, &lab.goal->solution_model,
           &lab.goal->solution_insert, &lab.goal->solution_before});
    span(lab.goal->span);
  }
  if (lab.ghost) text(lab.ghost->run);
  for (const Lab::Task& task : lab.tasks) text(task.value);
  span(lab.span);
}

void Collector::take(const Figure& figure) {
  texts({&figure.model, &figure.keyframe, &figure.run, &figure.pin});
  for (const Lab::Overlay& overlay : figure.overlays) text(overlay.name);
  if (figure.from) texts({&figure.from->example, &figure.from->name});
  if (figure.animation) span(figure.animation->span);
  span(figure.seconds_span);
  span(figure.span);
}

void Collector::take_question(const Question& question) {
  for (const Option& option : question.options) span(option.span);
  for (const Proof& proof : question.proofs) {
    texts({&proof.model, &proof.mjcf, &proof.example, &proof.because, &proof.run, &proof.value});
    for (const LocatedText& option : proof.options) text(option);
    for (const LocatedText& value : proof.values) text(value);
    span(proof.span);
  }
  span(question.answer_span);
  span(question.span);
}

void Collector::tree(const JsonValue& value) {
  span(value.span);
  text(value.string);
  for (const JsonValue& item : value.items) tree(item);
  for (const JsonMember& member : value.members) {
    text(member.key);
    tree(member.value);
  }
}

}  // namespace

LocatedPieces pieces_of(const Block& block) {
  Collector collector;
  std::visit([&](const auto& of_kind) { collector.take(of_kind); }, block);
  return collector.pieces();
}

}  // namespace mjcourse
