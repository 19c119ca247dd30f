#include "lesson/read_quiz.h"

#include <cmath>
#include <string>
#include <utility>

#include "base/nearest.h"
#include "lesson/json_object.h"
#include "lesson/read_proof.h"

namespace mjcourse {
namespace {

// Whether there are options and the answer is one of them.
bool read_options(JsonObject& object, Question& question, LessonReader& reader) {
  const std::vector<JsonValue>& options = object.required_list("options");
  for (const JsonValue& option : options) {
    if (option.kind != JsonValue::Kind::string) {
      report_kind("options", option, "a string", reader.reading());
    }
    question.options.push_back(reader.fragment(option.string));
  }
  const double last = static_cast<double>(options.size()) - 1;
  const bool is_index = question.answer >= 0 && question.answer <= last &&
                        question.answer == std::floor(question.answer);
  if (!options.empty() && !is_index) {
    reader.reading().error("E-quiz-form", question.answer_span,
                           "\"answer\" is the index of the right option, counted from 0");
    return false;
  }
  return !options.empty();
}

std::optional<Question> read_question(const JsonValue& value, LessonReader& reader) {
  Reading& reading = reader.reading();
  JsonObject object(value, "question", reading);
  const LocatedText kind = object.required_string("kind");
  if (kind.text == "multi" || kind.text == "order") {
    reading.error("E-not-yet", kind.span(),
                  "a question of kind \"" + kind.text +
                      "\" belongs to "
                      "the lesson language, but this version of mjcourse cannot do it yet");
    return std::nullopt;
  }
  if (kind.text != "numeric" && kind.text != "mcq") {
    if (!kind.text.empty()) {
      reading.error("E-quiz-form", kind.span(),
                    "there is no question of kind \"" + kind.text + "\"",
                    suggest(kind.text, {"numeric", "mcq"}));
    }
    return std::nullopt;
  }
  Question question;
  question.span = value.span;
  question.kind = kind.text == "mcq" ? Question::Kind::choice : Question::Kind::numeric;
  question.text = reader.fragment(object.required_string("q"));
  question.explanation = reader.fragment(object.string("explain"));
  const std::optional<double> answer = object.optional_number("answer");
  if (answer) {
    question.answer = *answer;
    question.answer_span = object.find("answer")->span;
  } else if (!object.has("answer")) {
    reading.error("E-json-missing", {value.span.begin, value.span.begin + 1},
                  "this question has no \"answer\"", "add \"answer\": …");
  }
  bool answered = answer.has_value();
  if (question.kind == Question::Kind::choice) {
    answered = read_options(object, question, reader) && answered;
  } else {
    question.tolerance = object.number("tol", 0);
    question.unit = object.string("unit").text;
  }
  for (const JsonValue& proof : object.list("verify")) {
    if (auto read = read_proof(proof, question, reading)) question.proofs.push_back(*read);
  }
  object.not_yet("hint");
  object.finish();
  return answered ? std::optional(std::move(question)) : std::nullopt;
}

}  // namespace

std::optional<Quiz> read_quiz(Fence& fence, LessonReader& reader) {
  Reading& reading = reader.reading();
  fence.finish("quiz", reading);
  const std::optional<JsonValue> json = parse_json(fence.body(), reading);
  if (!json) return std::nullopt;
  JsonObject object(*json, "quiz", reading);
  Quiz quiz;
  quiz.id = object.required_string("id").text;
  quiz.title = object.string("title").text;
  for (const JsonValue& question : object.required_list("questions")) {
    if (auto read = read_question(question, reader)) quiz.questions.push_back(std::move(*read));
  }
  object.finish();
  return quiz;
}

}  // namespace mjcourse
