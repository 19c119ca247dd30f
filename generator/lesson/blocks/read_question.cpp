#include "lesson/blocks/read_question.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/nearest.h"
#include "lesson/blocks/read_proof.h"
#include "lesson/json/json_object.h"
#include "lesson/json/quiz_vocabulary.h"

namespace mjcourse {
namespace {

using Kind = Question::Kind;

// Null (reported) where it is none.
const Vocabulary* read_kind(const JsonValue& value, Question& question, Reading& reading) {
  const LocatedText kind = JsonObject(value, words::kQuestion, reading).string("kind");
  if (kind.text == "mcq") question.kind = Kind::mcq;
  if (kind.text == "multi") question.kind = Kind::multi;
  if (kind.text == "order") question.kind = Kind::order;
  const Vocabulary* vocabulary = words::kQuestion.variant(kind.text);
  if (vocabulary != nullptr || kind.text.empty()) return vocabulary;
  std::vector<std::string> known;
  for (const Variant& one : words::kQuestion.variants) known.emplace_back(one.word);
  reading.error("E-quiz-form", kind.span(), "there is no question of kind \"" + kind.text + "\"",
                suggest(kind.text, known));
  return nullptr;
}

// A string, or for an option of a choice {"text": …, "feedback": …}.
Option read_option(const std::string& key, const JsonValue& value, LessonReader& reader) {
  Option option;
  option.span = value.span;
  if (value.kind == JsonValue::Kind::string) {
    option.text = reader.fragment(value.string);
  } else if (value.kind == JsonValue::Kind::object && key == "options") {
    JsonObject object(value, words::kOption, reader.reading());
    option.text = reader.fragment(object.string("text"));
    option.feedback = reader.fragment(object.string("feedback"));
    object.finish();
  } else {
    const bool may_have_feedback = key == "options";
    report_kind(key, value,
                may_have_feedback ? "a string, or {\"text\": …, \"feedback\": …}" : "a string",
                reader.reading());
  }
  return option;
}

// The options of a choice or the items of an order; whether there are enough to choose from.
bool read_options(const std::string& key, JsonObject& object, Question& question,
                  LessonReader& reader) {
  const std::vector<JsonValue>& options = object.list(key);
  std::vector<std::string> texts;
  for (const JsonValue& value : options) {
    Option option = read_option(key, value, reader);
    texts.push_back(option.text ? plain_text(option.text.get()) : "");
    const bool twice = std::count(texts.begin(), texts.end(), texts.back()) > 1;
    if (twice && !texts.back().empty()) {
      reader.reading().error("E-quiz-form", option.span,
                             "\"" + texts.back() + "\" stands twice in \"" + key + "\"");
    }
    question.options.push_back(std::move(option));
  }
  const JsonValue* list = object.find(key);
  if (list == nullptr || list->kind != JsonValue::Kind::array) return false;
  const auto count = static_cast<double>(options.size());
  if (count >= words::kOptionCount.least && count <= words::kOptionCount.most) return true;
  reader.reading().error("E-quiz-form", list->span,
                         "\"" + key + "\" " + std::string(words::kOptionCount.text) + ", not " +
                             std::to_string(options.size()));
  return false;
}

// Add the option that `value` counts to the right ones.
bool read_index(const JsonValue& value, Question& question, Reading& reading) {
  const double last = static_cast<double>(question.options.size()) - 1;
  std::string wrong;
  if (value.number < 0 || value.number > last || value.number != std::floor(value.number)) {
    const Vocabulary& words = question.kind == Kind::mcq ? words::kSingle : words::kMulti;
    wrong = "\"answer\" " + std::string(words.find("answer")->limits.text);
  } else if (std::count(question.right.begin(), question.right.end(), value.number) > 0) {
    wrong = "this option is in \"answer\" already";
  }
  if (!wrong.empty()) {
    reading.error("E-quiz-form", value.span, wrong);
    return false;
  }
  question.right.push_back(static_cast<std::size_t>(value.number));
  return true;
}

bool read_indices(const JsonValue& answer, Question& question, Reading& reading) {
  bool good = true;
  for (const JsonValue& index : answer.items) {
    if (index.kind != JsonValue::Kind::number) {
      report_kind("answer", index, "the index of an option", reading);
      good = false;
    } else {
      good = read_index(index, question, reading) && good;
    }
  }
  if (answer.items.empty()) {
    reading.error("E-quiz-form", answer.span, "\"answer\" is empty: no option is right",
                  "add an option that is right, such as \"none of these\"");
  }
  std::sort(question.right.begin(), question.right.end());
  return good && !answer.items.empty();
}

// Whether the answer can be judged.
bool read_answer(JsonObject& object, Question& question, Reading& reading) {
  const JsonValue* answer = object.require("answer");
  if (answer == nullptr) return false;
  question.answer_span = answer->span;
  const bool listed = question.kind == Kind::multi;
  const JsonValue::Kind expected = listed ? JsonValue::Kind::array : JsonValue::Kind::number;
  if (answer->kind != expected) {
    report_kind("answer", *answer,
                listed ? "a list of the right options' indices" : kind_name(expected), reading);
    return false;
  }
  question.answer = answer->number;
  if (question.kind == Kind::numeric) return true;
  if (question.options.empty()) return false;
  return listed ? read_indices(*answer, question, reading) : read_index(*answer, question, reading);
}

// What a number has beside its answer.
bool read_numeric(JsonObject& object, Question& question, Reading& reading) {
  const int mistakes = reading.mistakes();
  question.tolerance = read_tolerance(object, reading);
  const bool good = reading.mistakes() == mistakes;
  question.unit = object.string("unit").text;
  if (!read_answer(object, question, reading)) return false;
  if (question.tolerance.relative && question.answer == 0) {
    reading.error("E-quiz-form", object.find("tol")->span, "a percentage of 0 leaves no room",
                  "write \"tol\" as a number");
  }
  return good;
}

// An order stands in "items" as it should be.
bool read_order(JsonObject& object, Question& question, LessonReader& reader) {
  const bool good = read_options("items", object, question, reader);
  if (const JsonValue* answer = object.misplaced("answer")) {
    reader.reading().error("E-quiz-form", answer->span,
                           "an order has no \"answer\": its \"items\" stand in the right order",
                           "leave \"answer\" out");
  }
  return good;
}

}  // namespace

std::optional<Question> read_question(const JsonValue& value, LessonReader& reader) {
  Reading& reading = reader.reading();
  Question question;
  question.span = value.span;
  const Vocabulary* vocabulary = read_kind(value, question, reading);
  if (vocabulary == nullptr) return std::nullopt;
  JsonObject object(value, *vocabulary, reading);
  object.find("kind");
  question.text = reader.fragment(object.string("q"));
  question.hint = reader.fragment(object.string("hint"));
  question.explanation = reader.fragment(object.string("explain"));
  bool good = true;
  if (question.kind == Kind::numeric) {
    good = read_numeric(object, question, reading);
  } else if (question.kind == Kind::order) {
    good = read_order(object, question, reader);
  } else {
    const bool listed = read_options("options", object, question, reader);
    good = read_answer(object, question, reading) && listed;
  }
  for (const JsonValue& proof : object.list("verify")) {
    if (auto read = read_proof(proof, question, reading)) question.proofs.push_back(*read);
  }
  object.finish();
  return good ? std::optional(std::move(question)) : std::nullopt;
}

}  // namespace mjcourse
