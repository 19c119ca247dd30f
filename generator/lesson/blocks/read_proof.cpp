#include "lesson/blocks/read_proof.h"

#include <string>
#include <tuple>
#include <utility>

#include "base/counted.h"
#include "lesson/json/json_object.h"
#include "lesson/json/quiz_vocabulary.h"

namespace mjcourse {
namespace {

std::map<std::string, int> read_joints(const JsonValue* value, Reading& reading) {
  std::map<std::string, int> joints;
  if (value == nullptr) return joints;
  JsonObject object(*value, words::kJoints, reading);
  for (const Key& key : words::kJoints.keys) {
    const std::string kind(key.name);
    if (const int count = object.whole(kind, 0)) joints[kind] = count;
  }
  object.finish();
  return joints;
}

std::vector<LocatedText> read_expressions(JsonObject& object, const std::string& key,
                                          Reading& reading) {
  std::vector<LocatedText> expressions;
  for (const JsonValue& expression : object.list(key)) {
    if (expression.kind != JsonValue::Kind::string) {
      report_kind(key, expression, "a string", reading);
    }
    expressions.push_back(expression.string);
  }
  return expressions;
}

// How a question of each kind is proved: by a value, or by one expression for each…
struct Form {
  const char* question;  // as messages call it
  const char* key;       // of the list of expressions
  const char* each;
};

Form form_of(Question::Kind kind) {
  switch (kind) {
    case Question::Kind::numeric:
      return {"a number", "", ""};
    case Question::Kind::mcq:
    case Question::Kind::multi:
      return {"a choice", "options", "option"};
    case Question::Kind::order:
      return {"an order", "values", "item"};
  }
  return {};
}

// What is wrong with how `proof` finds an answer; its message and cure, empty for nothing.
std::pair<std::string, std::string> fault_of(const Proof& proof, const Question& question) {
  const Form form = form_of(question.kind);
  const bool listed = question.kind != Question::Kind::numeric;
  if (!proof.example.text.empty() && !(proof.run.text.empty() && proof.seconds == 0 &&
                                       proof.options.empty() && proof.values.empty())) {
    return {
        "an \"example\" has run already: it takes the name of a result as \"value\", and no script",
        ""};
  }
  const auto& expressions = question.kind == Question::Kind::order ? proof.values : proof.options;
  const std::string key = std::string("\"") + form.key + "\"";
  if (!listed && !(proof.options.empty() && proof.values.empty())) {
    return {"a number is proved by a \"value\"", ""};
  }
  if (proof.options.size() + proof.values.size() != expressions.size()) {
    return {std::string(form.question) + " is proved by " + key + ", one expression each", ""};
  }
  if (proof.value.text.empty() == expressions.empty()) {
    const std::string or_list =
        listed ? ", or " + key + " with one expression for each " + form.each : "";
    return {"a proof needs a \"value\"" + or_list, ""};
  }
  if (!expressions.empty() && expressions.size() != question.options.size()) {
    return {"the proof has " + counted(expressions.size(), "expression") + " for " +
                std::to_string(question.options.size()) + " " + form.each + "s",
            std::string("write one expression for each ") + form.each + ", in their order"};
  }
  if (listed && expressions.empty() && !proof.equals) {
    return {std::string(form.question) + " is proved by " + key +
                ", one expression each; a \"value\" needs \"equals\"",
            ""};
  }
  return {};
}

}  // namespace

std::optional<Proof> read_proof(const JsonValue& value, const Question& question,
                                Reading& reading) {
  const int mistakes = reading.mistakes();
  JsonObject object(value, words::kProof, reading);
  Proof proof;
  proof.span = value.span;
  const bool by_joints = object.has("joints");
  proof.joints = read_joints(object.find("joints"), reading);
  proof.model = object.string("model");
  proof.mjcf = object.script("mjcf");
  proof.example = object.string("example");
  proof.because = object.string("because");
  proof.run = object.script("run");
  proof.seconds = object.number("seconds", 0);
  proof.value = object.script("value");
  proof.equals = object.optional_number("equals");
  proof.options = read_expressions(object, "options", reading);
  proof.values = read_expressions(object, "values", reading);
  object.finish();

  // What could not be read as it stands proves something else.
  if (reading.mistakes() > mistakes) return std::nullopt;
  const int sources = (by_joints ? 1 : 0) + (proof.model.text.empty() ? 0 : 1) +
                      (proof.mjcf.text.empty() ? 0 : 1) + (proof.example.text.empty() ? 0 : 1) +
                      (proof.because.text.empty() ? 0 : 1);
  std::string wrong, cure;
  if (sources != 1) {
    wrong =
        "a proof needs exactly one of \"joints\", \"model\", \"mjcf\", \"example\" and \"because\"";
  } else if (proof.because.text.empty()) {
    std::tie(wrong, cure) = fault_of(proof, question);
  }
  if (wrong.empty()) return proof;
  reading.error("E-proof-form", {value.span.begin, value.span.begin + 1}, wrong, cure);
  return std::nullopt;
}

}  // namespace mjcourse
