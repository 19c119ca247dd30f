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

#include "lesson/blocks/figure.h"
#include "lesson/blocks/lab.h"
#include "lesson/blocks/plot.h"
#include "lesson/blocks/quiz.h"
#include "lesson/syntax/located_text.h"
#include "lesson/syntax/markdown.h"

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

// [[term]] or [[term|shown text]]: a term of the course's glossary. Its node holds what is shown.
struct TermUse {
  LocatedText name;  // as written
  std::string key;   // what terms are matched by (lesson/glossary.h)
};

// ```cpp file=…: a whole program, or a region of one.
struct Example {
  LocatedText file;                      // relative to the course: "examples/x.cpp"
  std::optional<LocatedText> region;     // the name behind `#`
  LocatedText code;                      // the fence's body; empty to show the file
  double seconds = 10;                   // wall clock of a run
  int exit_code = 0;                     // as it is expected
  bool compiles = true;                  // false: the compiler's refusal is what it shows
  bool optimize = false;                 // -O2, for a program that computes much
  std::vector<std::string> arguments{};  // of its command line
  std::string native{};                  // why no page is to run it; "" where one may
  Span span{};                           // the opening fence
  std::vector<std::size_t> outputs{};    // the blocks that state its output
  bool quoted = true;                    // may a lesson quote what it reports?

  std::string name() const;  // "x" of "examples/x.cpp"
};

// ```cpp exercise: a program of which the reader writes a region (lesson/syntax/exercise_text.h).
struct Exercise {
  Example program;                    // with that region, and without code
  std::optional<LocatedText> hidden;  // the file of checks that no page shows
  Span span{};                        // the opening fence
};

// ```LANGUAGE unchecked: what is shown and not run, and says so.
struct Unchecked {
  LocatedText code;
  std::string language;  // "cpp", "sh" …
  std::string because;   // why nobody runs it; may be empty
  Span span;             // the opening fence
};

// ```cpp snippet: the body of a function, which sees `model` and `data`.
struct Snippet {
  LocatedText model;                   // its name
  LocatedText code;                    // all that is compiled
  std::string shown;                   // without the lines that began with `//| `
  double seconds = 10;                 // wall clock of a run
  std::string native{};                // why no page is to run it; "" where one may
  Span span{};                         // the opening fence
  std::vector<std::size_t> outputs{};  // the blocks that state its output
};

// ```sh run: commands as a reader types them, run in a folder that has these files of the course.
struct Commands {
  LocatedText code;
  std::vector<LocatedText> files;      // relative to the course; a folder stands for all in it
  double seconds = 10;                 // wall clock of all of them
  Span span{};                         // the opening fence
  std::vector<std::size_t> outputs{};  // the blocks that state their output
};

// ```xml model=…: lines of a model of the course.
struct ModelExcerpt {
  LocatedText model;  // its name
  LocatedText text;
  Span span;
};

// ```xml mjcf: a whole model inside the lesson.
struct InlineModel {
  LocatedText text;
  bool compiles = true;  // false: MuJoCo's refusal is what it shows
  Span span;
};

// ```text: what an example, a snippet or commands print, as the lesson states it.
struct Output {
  LocatedText text;
  std::optional<double> tolerance;  // absolute; without one, a unit of the last printed place
  std::size_t example = 0;          // the block that prints it
  Span span;
  bool apart = false;  // it does not stand below its program, so it is shown where it stands
};

// ![alt](picture.png "where it comes from"): a picture beside the lesson, of which nothing is
// proved.
struct Image {
  LocatedText file;   // relative to the lesson's folder
  std::string alt;    // what it shows, in words
  std::string title;  // where it comes from; may be empty
  bool alone = true;  // all there is in its paragraph, for which it stands
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
  Span span{};           // the kind
  std::string source{};  // what its last paragraph `Source: …` says, with the link's target
  std::size_t end = 0;   // the lesson's block behind the last one that stands in it
};

// ````demo: a piece of a lesson, shown as it is written and as what it becomes. The blocks of the
// document are the lesson's own, as if they stood there without the demo.
struct Demo {
  std::string source;
  Document document;
};

// Shown by its neighbour: the "Output:" paragraph and the output below an example.
struct Shown {};

using Block = std::variant<Math, InlineValue, TermUse, Example, Exercise, Unchecked, Snippet,
                           Commands, ModelExcerpt, InlineModel, Output, Image, Io, Callout, Lab,
                           Figure, Plot, Quiz, Demo, Shown>;

}  // namespace mjcourse
