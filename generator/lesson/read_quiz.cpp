#include "lesson/read_quiz.h"

#include <cmath>
#include <string>
#include <utility>

#include "base/nearest.h"
#include "lesson/json_object.h"

namespace mjcourse {
namespace {

constexpr double kMostSeconds = 100;  // simulated for one proof

std::map<std::string, int> read_joints(const JsonValue* value, Reading& reading) {
  std::map<std::string, int> joints;
  if (value == nullptr) return joints;
  JsonObject object(*value, "set of joints", reading);
  for (const char* kind : {"free", "ball", "slide", "hinge"}) {
    const double count = object.number(kind, 0);
    if (count < 0 || count > 1000 || count != std::floor(count)) {
      reading.error("E-json-range", object.find(kind)->span,
                    "\"" + std::string(kind) + "\" counts joints: a whole number from 0 to 1000");
    } else if (count > 0) {
      joints[kind] = static_cast<int>(count);
    }
  }
  object.finish();
  return joints;
}

// Nothing when it does not say what to do.
std::optional<Proof> read_proof(const JsonValue& value, const Question& question,
                                Reading& reading) {
  JsonObject object(value, "proof", reading);
  Proof proof;
  proof.span = value.span;
  const bool by_joints = object.has("joints");
  proof.joints = read_joints(object.find("joints"), reading);
  proof.model = object.string("model");
  proof.mjcf = object.script("mjcf");
  proof.because = object.string("because");
  proof.run = object.script("run");
  proof.seconds = object.number("seconds", 0);
  if (proof.seconds < 0 || proof.seconds > kMostSeconds) {
    reading.error("E-json-range", object.find("seconds")->span,
                  "\"seconds\" is simulated time: from 0 to 100");
    proof.seconds = 0;
  }
  proof.value = object.script("value");
  proof.equals = object.optional_number("equals");
  for (const JsonValue& option : object.list("options")) {
    if (option.kind != JsonValue::Kind::string) report_kind("options", option, "a string", reading);
    proof.options.push_back(option.string);
  }
  object.not_yet("example");
  object.finish();

  if (value.kind != JsonValue::Kind::object) return std::nullopt;
  const Span open{value.span.begin, value.span.begin + 1};
  const int sources = (by_joints ? 1 : 0) + (proof.model.text.empty() ? 0 : 1) +
                      (proof.mjcf.text.empty() ? 0 : 1) + (proof.because.text.empty() ? 0 : 1);
  const bool computes = proof.because.text.empty();
  std::string wrong, cure;
  if (sources != 1) {
    wrong = "a proof needs exactly one of \"joints\", \"model\", \"mjcf\" and \"because\"";
  } else if (computes && proof.value.text.empty() == proof.options.empty()) {
    wrong = "a proof needs a \"value\", or \"options\" with one expression for each option";
  } else if (!proof.options.empty() && proof.options.size() != question.options.size()) {
    wrong = "the proof has " + std::to_string(proof.options.size()) + " expressions for " +
            std::to_string(question.options.size()) + " options";
    cure = "write one expression for each option, in their order";
  } else if (question.kind == Question::Kind::choice && computes && proof.options.empty() &&
             !proof.equals) {
    wrong = "a choice is proved by \"options\", one expression each; a \"value\" needs \"equals\"";
  }
  if (wrong.empty()) return proof;
  reading.error("E-proof-form", open, wrong, cure);
  return std::nullopt;
}

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
