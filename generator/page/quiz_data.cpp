// The data that the templates of a knowledge check are fed with; their own comments describe it.
#include <cctype>
#include <cstdio>

#include "page/page_writer.h"

namespace mjcourse {
namespace {

using nlohmann::json;

std::string shortest(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

// `text` as a part of an HTML id that any selector can name: "1.2-check" → "1-2-check".
std::string as_id(std::string text) {
  for (char& c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
  }
  return text;
}

// What a proof was found on, as a sentence goes on: "a model with 7 hinge joints".
std::string built_on(const std::string& built, const Course& course) {
  for (const std::string& name : course.models) {
    if (name == built) return built + ".xml";
  }
  return "a model with " + built;
}

}  // namespace

json PageWriter::data_of(const Question& question, const QuestionResult& result,
                         const std::string& id, std::size_t number) {
  const bool numeric = question.kind == Question::Kind::numeric;
  json data{{"id", id},
            {"number", std::to_string(number)},
            {"kind", numeric ? "numeric" : "mcq"},
            {"numeric", numeric},
            {"key", shortest(question.answer)},
            {"tolerance", shortest(question.tolerance)},
            {"q", inline_html(question.text)},
            {"unit", question.unit},
            {"options", json::array()},
            {"answer", escape_html(shortest(question.answer))},
            {"explain", html(question.explanation)},
            {"proved", result.proved},
            {"proof", json::array()},
            {"because", result.because}};
  for (std::size_t i = 0; i < question.options.size(); ++i) {
    const std::string letter(1, static_cast<char>('A' + i));
    const bool right = static_cast<std::size_t>(question.answer) == i;
    const std::string text = inline_html(question.options[i]);
    data["options"].push_back(
        {{"id", id + "-" + letter}, {"html", text}, {"letter", letter}, {"right", right}});
    if (!right) continue;
    data["key"] = letter;
    data["answer"] = letter + ". " + text;
  }
  for (const ProofResult& proof : result.proofs) {
    data["proof"].push_back({{"built", built_on(proof.built, course_)},
                             {"expression", proof.expression},
                             {"value", proof.value}});
  }
  return data;
}

json PageWriter::data_of(const Quiz& quiz, std::size_t index) {
  const auto* result = results_.get<QuizResult>(index);
  const std::string title = quiz.title.empty() ? "Knowledge check" : quiz.title;
  const std::string id = "quiz-" + as_id(quiz.id);
  json data{{"id", id}, {"title", title}, {"questions", json::array()}};
  for (std::size_t i = 0; i < quiz.questions.size(); ++i) {
    const QuestionResult answer = result != nullptr ? result->questions[i] : QuestionResult{};
    data["questions"].push_back(
        data_of(quiz.questions[i], answer, id + "-" + std::to_string(i + 1), i + 1));
  }
  contents_.push_back({{"id", id}, {"title", escape_html(title)}, {"children", json::array()}});
  return data;
}

}  // namespace mjcourse
