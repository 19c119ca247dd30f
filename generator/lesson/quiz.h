// ```quiz: questions, their answers, and how each answer is found without the author.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lesson/located_text.h"
#include "lesson/markdown.h"

namespace mjcourse {

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

}  // namespace mjcourse
