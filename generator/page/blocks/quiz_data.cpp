// The data that the templates of a knowledge check are fed with; their own comments describe it.
// Tested by tests/generator/page/blocks/page_writer_test.cpp.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "page/blocks/page_writer.h"
#include "page/html/anchors.h"
#include "page/html/shuffled.h"
#include "page/html/site_paths.h"
#include "page/html/verification.h"

namespace mjcourse {
namespace {

using nlohmann::json;

std::string shortest(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

// The shortest of which nothing is lost: an answer is held against every digit.
std::string exact(double value) {
  char text[64];
  for (int digits = 10; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return text;
}

const char* kind_text(Question::Kind kind) {
  switch (kind) {
    case Question::Kind::numeric:
      return "numeric";
    case Question::Kind::mcq:
      return "mcq";
    case Question::Kind::multi:
      return "multi";
    case Question::Kind::order:
      return "order";
  }
  return "";
}

std::string letter(std::size_t index) {
  return {static_cast<char>('A' + index)};
}

// By how much an answer may differ, in words: "1 %", "0.05 m", nothing. The spaces do not break.
std::string within(const Question& question) {
  const Tolerance& tolerance = question.tolerance;
  if (tolerance.amount == 0) return "";
  if (tolerance.relative) return shortest(100 * tolerance.amount) + "\u00a0%";
  const std::string amount = shortest(tolerance.amount);
  return question.unit.empty() ? amount : amount + "\u00a0" + question.unit;
}

}  // namespace

// The options of a choice, in the author's order; each right one is an answer and a part of the
// key.
void PageWriter::add_options(const Question& question, json& data) {
  const std::string id = data["id"];
  std::string key;
  for (std::size_t i = 0; i < question.options.size(); ++i) {
    const Option& option = question.options[i];
    const std::string text = inline_html(option.text);
    data["options"].push_back(
        {{"id", id + "-" + letter(i)}, {"letter", letter(i)}, {"html", text}});
    if (option.feedback) {
      data["remarks"].push_back({{"letter", letter(i)}, {"html", html(option.feedback)}});
    }
    if (std::binary_search(question.right.begin(), question.right.end(), i)) {
      data["answers"].push_back(letter(i) + ". " + text);
      key += (key.empty() ? "" : " ") + letter(i);
    }
  }
  data["key"] = key;
}

// The items of an order, mixed, each with the letter of the place where it is shown first. The key
// is these letters in the right order.
void PageWriter::add_items(const Question& question, json& data) {
  const std::string id = data["id"];
  const std::vector<std::size_t> shown = shuffled(question.options.size(), id);
  std::string key(2 * shown.size() - 1, ' ');
  for (std::size_t place = 0; place < shown.size(); ++place) {
    data["options"].push_back({{"id", id + "-" + letter(place)},
                               {"letter", letter(place)},
                               {"html", inline_html(question.options[shown[place]].text)}});
    key[2 * shown[place]] = letter(place)[0];
  }
  for (const Option& item : question.options) data["answers"].push_back(inline_html(item.text));
  data["key"] = key;
}

json PageWriter::data_of(const Question& question, const QuestionResult& result,
                         const std::string& id, std::size_t number) {
  const Question::Kind kind = question.kind;
  json data{{"id", id},
            {"number", std::to_string(number)},
            {"kind", kind_text(kind)},
            {"numeric", kind == Question::Kind::numeric},
            {"multi", kind == Question::Kind::multi},
            {"order", kind == Question::Kind::order},
            {"key", exact(question.answer)},
            {"tolerance", shortest(question.tolerance.around(question.answer))},
            {"within", within(question)},
            {"q", inline_html(question.text)},
            {"unit", question.unit},
            {"options", json::array()},
            {"hint", html(question.hint)},
            {"answers", json::array()},
            {"explain", html(question.explanation)},
            {"remarks", json::array()},
            {"proved", result.proved},
            {"by_program", result.by_program},
            {"proof", json::array()},
            {"because", result.because}};
  if (kind == Question::Kind::numeric) {
    data["answers"].push_back(escape_html(exact(question.answer)));
  } else if (kind == Question::Kind::order) {
    add_items(question, data);
  } else {
    add_options(question, data);
  }
  for (const ProofResult& proof : result.proofs) {
    data["proof"].push_back(
        {{"built", proof.built}, {"expression", proof.expression}, {"value", proof.value}});
  }
  return data;
}

// The way to what the verification page says of a block's claim; "" where it says nothing.
std::string PageWriter::report_on(std::size_t block, std::size_t part) const {
  const Claims& claims = results_.claims;
  const auto claim = std::find_if(claims.begin(), claims.end(), [&](const Claim& known) {
    return known.block == block && known.part == part;
  });
  if (claim == claims.end()) return "";
  return from_root(kVerificationPage) + "#" +
         claim_anchor(lesson_, static_cast<std::size_t>(claim - claims.begin()));
}

json PageWriter::data_of(const Quiz& quiz, std::size_t index) {
  const auto* result = results_.get<QuizResult>(index);
  const std::string title = quiz.title.empty() ? "Knowledge check" : quiz.title;
  const std::string id = "quiz-" + as_id(quiz.id);
  json data{{"id", id}, {"title", title}, {"questions", json::array()}};
  for (std::size_t i = 0; i < quiz.questions.size(); ++i) {
    const QuestionResult answer = result != nullptr ? result->questions[i] : QuestionResult{};
    data["questions"].push_back(
        data_of(quiz.questions[i], answer, question_anchor(quiz, i), i + 1));
    data["questions"].back()["report"] = report_on(index, i);
  }
  contents_.push_back({{"id", id}, {"title", escape_html(title)}, {"children", json::array()}});
  return data;
}

json PageWriter::questions() {
  json all = json::array();
  for (std::size_t i = 0; i < lesson_.blocks.size(); ++i) {
    const auto* quiz = std::get_if<Quiz>(&lesson_.blocks[i]);
    if (quiz == nullptr) continue;
    json data = data_of(*quiz, i);
    for (json& question : data["questions"]) all.push_back(std::move(question));
  }
  return all;
}

}  // namespace mjcourse
