#include "lsp/named_things.h"

#include <variant>

#include "base/any_of.h"

namespace mjcourse {
namespace {

class Gatherer {
 public:
  using Kind = NamedThing::Kind;

  void operator()(const InlineValue& value) {
    // Whether it is a model's or a program's is for the course to say.
    add(Kind::model, value.source);
    add(Kind::program, value.source);
  }
  void operator()(const TermUse& term) { things.push_back({Kind::term, term.name, term.key}); }
  void operator()(const Example& example) {
    things.push_back({Kind::file, example.file, example.region ? example.region->text : ""});
  }
  void operator()(const Exercise& exercise) {
    (*this)(exercise.program);
    if (exercise.hidden) things.push_back({Kind::file, *exercise.hidden, ""});
  }
  void operator()(const Snippet& snippet) { add(Kind::model, snippet.model); }
  void operator()(const ModelExcerpt& excerpt) { add(Kind::model, excerpt.model); }
  void operator()(const Lab& lab) {
    add(Kind::model, lab.model);
    if (lab.goal) add(Kind::model, lab.goal->solution_model);
  }
  void operator()(const Figure& figure) {
    add(Kind::model, figure.model);
    if (figure.from) add(Kind::program, figure.from->example);
  }
  void operator()(const Plot& plot) { add(Kind::program, plot.example); }
  void operator()(const Quiz& quiz) {
    for (const Question& question : quiz.questions) {
      for (const Proof& proof : question.proofs) {
        add(Kind::model, proof.model);
        add(Kind::program, proof.example);
      }
    }
  }
  template <
      AnyOf<Math, Unchecked, Commands, InlineModel, Output, Image, Io, Callout, Demo, Shown> Other>
  void operator()(const Other&) {}

  void add(Kind kind, const LocatedText& name) {
    if (!name.text.empty()) things.push_back({kind, name, ""});
  }

  std::vector<NamedThing> things;
};

}  // namespace

std::vector<NamedThing> named_things(const Lesson& lesson) {
  Gatherer gatherer;
  for (const Block& block : lesson.blocks) std::visit(gatherer, block);
  for (const Link& link : lesson.links) gatherer.add(NamedThing::Kind::link, link.target);
  return std::move(gatherer.things);
}

}  // namespace mjcourse
