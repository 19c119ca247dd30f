// ```quiz: questions, their answers, and how each answer is found without the author.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lesson/json/tolerance.h"
#include "lesson/syntax/located_text.h"
#include "lesson/syntax/markdown.h"

namespace mjcourse {

// How a question's answer is found without the author.
struct Proof {
  std::map<std::string, int> joints;  // kind → how many; or
  LocatedText model;                  // a model of the course; or
  LocatedText mjcf;                   // the model itself; or
  LocatedText example;                // one whose result is the value; or
  LocatedText because;                // no proof: the reason why the answer is only asserted
  LocatedText run;                    // a script before the value
  double seconds = 0;                 // simulated between `run` and the value
  LocatedText value;                  // an expression, or the result's name; or
  std::vector<LocatedText> options;   // one for each option: exactly the right ones hold; or
  std::vector<LocatedText> values;    // one for each item: they grow in the right order
  std::optional<double> equals;       // what `value` must be; without it, the question's answer
  Span span;
};

struct Option {
  Document text;
  Document feedback;  // what its author says to a reader who chose it
  Span span;
};

struct Question {
  enum class Kind { numeric, mcq, multi, order };
  Kind kind = Kind::numeric;
  Document text, hint, explanation;
  double answer = 0;  // of a numeric one
  Tolerance tolerance;
  std::string unit;
  std::vector<Option> options;     // of an order, the items as they should stand
  std::vector<std::size_t> right;  // the right options' indices, in rising order
  Span answer_span;                // nowhere for an order, whose items are the answer
  std::vector<Proof> proofs;
  Span span;
};

struct Quiz {
  std::string id, title;
  std::vector<Question> questions;
};

}  // namespace mjcourse
