#include "page/blocks/quiz_data.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

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

// The options of a choice, in the author's order; each right one is an answer and a part of the
// key.
void add_options(const Question& question, const LessonContext& context, json& data) {
  const std::string id = data["id"];
  std::string key;
  for (std::size_t i = 0; i < question.options.size(); ++i) {
    const Option& option = question.options[i];
    const std::string text = context.inline_html(option.text);
    data["options"].push_back(
        {{"id", id + "-" + letter(i)}, {"letter", letter(i)}, {"html", text}});
    if (option.feedback) {
      data["remarks"].push_back({{"letter", letter(i)}, {"html", context.html(option.feedback)}});
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
void add_items(const Question& question, const LessonContext& context, json& data) {
  const std::string id = data["id"];
  const std::vector<std::size_t> shown = shuffled(question.options.size(), id);
  std::string key(2 * shown.size() - 1, ' ');
  for (std::size_t place = 0; place < shown.size(); ++place) {
    data["options"].push_back({{"id", id + "-" + letter(place)},
                               {"letter", letter(place)},
                               {"html", context.inline_html(question.options[shown[place]].text)}});
    key[2 * shown[place]] = letter(place)[0];
  }
  for (const Option& item : question.options)
    data["answers"].push_back(context.inline_html(item.text));
  data["key"] = key;
}

json question_data(const Question& question, const QuestionResult& result, const std::string& id,
                   std::size_t number, const LessonContext& context) {
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
            {"q", context.inline_html(question.text)},
            {"unit", question.unit},
            {"options", json::array()},
            {"hint", context.html(question.hint)},
            {"answers", json::array()},
            {"explain", context.html(question.explanation)},
            {"remarks", json::array()},
            {"proved", result.proved},
            {"by_program", result.by_program},
            {"proof", json::array()},
            {"because", result.because}};
  if (kind == Question::Kind::numeric) {
    data["answers"].push_back(escape_html(exact(question.answer)));
  } else if (kind == Question::Kind::order) {
    add_items(question, context, data);
  } else {
    add_options(question, context, data);
  }
  for (const ProofResult& proof : result.proofs) {
    data["proof"].push_back(
        {{"built", proof.built}, {"expression", proof.expression}, {"value", proof.value}});
  }
  return data;
}

// The way to what the verification page says of a block's claim; "" where it says nothing.
std::string report_on(std::size_t block, std::size_t part, const LessonContext& context) {
  const Claims& claims = context.results.claims;
  const auto claim = std::find_if(claims.begin(), claims.end(), [&](const Claim& known) {
    return known.block == block && known.part == part;
  });
  if (claim == claims.end()) return "";
  return context.from_root(kVerificationPage) + "#" +
         claim_anchor(context.lesson, static_cast<std::size_t>(claim - claims.begin()));
}

}  // namespace

json quiz_data(const Quiz& quiz, std::size_t index, LessonContext& context) {
  const auto* result = context.results.get<QuizResult>(index);
  const std::string title = quiz.title.empty() ? "Knowledge check" : quiz.title;
  const std::string id = "quiz-" + as_id(quiz.id);
  json data{{"id", id}, {"title", title}, {"questions", json::array()}};
  for (std::size_t i = 0; i < quiz.questions.size(); ++i) {
    const QuestionResult answer = result != nullptr ? result->questions[i] : QuestionResult{};
    data["questions"].push_back(
        question_data(quiz.questions[i], answer, question_anchor(quiz, i), i + 1, context));
    data["questions"].back()["report"] = report_on(index, i, context);
  }
  context.list_heading(2, id, escape_html(title));
  return data;
}

json questions_data(LessonContext& context) {
  json all = json::array();
  for (std::size_t i = 0; i < context.lesson.blocks.size(); ++i) {
    const auto* quiz = std::get_if<Quiz>(&context.lesson.blocks[i]);
    if (quiz == nullptr) continue;
    json data = quiz_data(*quiz, i, context);
    for (json& question : data["questions"]) all.push_back(std::move(question));
  }
  return all;
}

}  // namespace mjcourse
