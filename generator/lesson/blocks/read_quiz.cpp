#include "lesson/blocks/read_quiz.h"

#include <utility>

#include "lesson/blocks/read_question.h"
#include "lesson/json/json_object.h"
#include "lesson/json/quiz_vocabulary.h"

namespace mjcourse {

std::optional<Quiz> read_quiz(Fence& fence, LessonReader& reader) {
  Reading& reading = reader.reading();
  fence.finish("quiz", {}, reading);
  const std::optional<JsonValue> json = parse_json(fence.body(), reading);
  if (!json) return std::nullopt;
  JsonObject object(*json, words::kQuiz, reading);
  Quiz quiz;
  quiz.id = object.string("id").text;
  quiz.title = object.string("title").text;
  for (const JsonValue& question : object.list("questions")) {
    if (auto read = read_question(question, reader)) quiz.questions.push_back(std::move(*read));
  }
  object.finish();
  return quiz;
}

}  // namespace mjcourse
