// The blocks of a lesson: what an author claims, as data, each with its place in the file.
//
// Prose stays in the Markdown tree; every construct of the lesson language beyond CommonMark
// becomes one of these. Reading makes them, evaluating finds out whether they are true, writing
// turns them into HTML.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lesson/lab.h"
#include "lesson/located_text.h"
#include "lesson/markdown.h"
#include "lesson/quiz.h"

namespace mjcourse {

// $…$ or $$…$$.
struct Math {
  LocatedText tex;  // between the dollars
  bool display = false;
};

// `{joint_zoo} model.nq` or `{l1_2_example} naive_qz :.4f` in a code span: a value of a model in
// its initial state, or a result that an example reported.
struct InlineValue {
  LocatedText source;      // the model's or the example's name
  LocatedText expression;  // over the model; or the result's name
  LocatedText format;      // "f", ".4f", "d" …, as in printf; empty for the shortest sensible
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

// Shown by its neighbour: the "Output:" paragraph and the output below an example.
struct Shown {};

using Block = std::variant<Math, InlineValue, Example, Output, Io, Callout, Lab, Quiz, Shown>;

}  // namespace mjcourse
