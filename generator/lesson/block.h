// The blocks of a lesson: what an author claims, as data, each with its place in the file.
//
// Prose stays in the Markdown tree; every construct of the lesson language beyond CommonMark
// becomes one of these. Reading makes them, evaluating finds out whether they are true, writing
// turns them into HTML.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lesson/lab.h"
#include "lesson/located_text.h"
#include "lesson/markdown.h"

namespace mjcourse {

// $…$ or $$…$$.
struct Math {
  LocatedText tex;  // between the dollars
  bool display = false;
};

// ```cpp file=…: a whole program.
struct Example {
  LocatedText file;                   // relative to the course: "examples/x.cpp"
  LocatedText code;                   // the fence's body; empty to show the file
  double seconds = 10;                // wall clock of a run
  Span span;                          // the opening fence
  std::optional<std::size_t> output;  // the block that states its output

  std::string name() const;  // "x" of "examples/x.cpp"
};

// ```text: what an example prints, as the lesson states it.
struct Output {
  LocatedText text;
  std::optional<double> tolerance;  // absolute; without one, a unit of the last printed place
  std::size_t example = 0;          // the block that prints it
  Span span;
};

// ```io: the INPUT / PROCESS / OUTPUT panel.
struct Io {
  struct Row {
    std::string label;
    Document text;
  };
  std::vector<Row> rows;
};

// > [!kind] Title
struct Callout {
  std::string kind;
  Document title;
  bool folded = false;
};

// How a question's answer is found without the author.
struct Proof {
  std::map<std::string, int> joints;  // kind → how many; or
  LocatedText model;                  // a model of the course; or
  LocatedText mjcf;                   // the model itself; or
  LocatedText because;                // no proof: the reason why the answer is only asserted
  LocatedText run;                    // a script before the value
  double seconds = 0;                 // simulated between `run` and the value
  LocatedText value;                  // an expression; or
  std::vector<LocatedText> options;   // one for each option: exactly the right ones hold
  std::optional<double> equals;       // what `value` must be; without it, the question's answer
  Span span;
};

struct Question {
  enum class Kind { numeric, choice };
  Kind kind = Kind::numeric;
  Document text;
  std::vector<Document> options;
  double answer = 0;  // the number, or the index of the right option
  Span answer_span;
  double tolerance = 0;
  std::string unit;
  Document explanation;
  std::vector<Proof> proofs;
  Span span;
};

// ```quiz
struct Quiz {
  std::string id, title;
  std::vector<Question> questions;
};

// Shown by its neighbour: the "Output:" paragraph and the output below an example.
struct Shown {};

using Block = std::variant<Math, Example, Output, Io, Callout, Lab, Quiz, Shown>;

}  // namespace mjcourse
