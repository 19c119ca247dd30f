#include "lesson/blocks/read_assignment.h"

#include <string>
#include <utility>

#include "lesson/json/lab_vocabulary.h"

namespace mjcourse {
namespace {

void read_solution(const JsonValue& value, bool editable, Reading& reading, Lab::Goal& goal) {
  JsonObject object(value, words::kSolution, reading);
  goal.solution_run = object.script("run");
  goal.solution_model = object.string("model");
  goal.solution_insert = object.script("insert");
  goal.solution_before =
      object.has("insert") ? object.required_string("before") : object.string("before");
  goal.solution_seconds = object.number("seconds", 0);
  object.finish();
  if (value.kind != JsonValue::Kind::object) return;
  const Span open{value.span.begin, value.span.begin + 1};
  const auto given = [](const LocatedText& text) { return text.text.empty() ? 0 : 1; };
  const LocatedText& edit = given(goal.solution_model) ? goal.solution_model : goal.solution_insert;
  if (!editable && given(edit)) {
    reading.error("E-lab-goal", edit.span(),
                  "a model can only be the solution where the reader edits one",
                  "write the solution as a script \"run\", or make the lab \"editable\"");
  } else if (given(goal.solution_run) + given(goal.solution_model) + given(goal.solution_insert) !=
             1) {
    reading.error("E-lab-goal", open,
                  "a solution is a script \"run\", a \"model\", or MJCF to \"insert\"",
                  "write one of them");
  } else if (given(goal.solution_insert) < given(goal.solution_before)) {
    reading.error("E-lab-goal", goal.solution_before.span(),
                  "\"before\" says where MJCF is inserted, and there is none",
                  "write it as \"insert\", or leave \"before\" out");
  } else if (given(goal.solution_insert) == given(goal.solution_before)) {
    return;
  }
  goal.solution_run = goal.solution_model = goal.solution_insert = {};
}

}  // namespace

std::optional<Lab::Predict> read_predict(const JsonValue* value, LessonReader& reader) {
  if (value == nullptr) return std::nullopt;
  JsonObject object(*value, words::kPrediction, reader.reading());
  Lab::Predict predict;
  predict.question = reader.fragment(object.string("q"));
  predict.run = object.script("run");
  predict.value = object.string("value");
  predict.seconds = object.number("seconds", predict.seconds);
  predict.tolerance = object.number("tol", predict.tolerance);
  predict.digits = object.whole("digits", predict.digits);
  predict.unit = object.string("unit").text;
  predict.explanation = reader.fragment(object.string("explain"));
  object.finish();
  if (predict.value.text.empty()) return std::nullopt;
  return predict;
}

std::optional<Lab::Goal> read_goal(const JsonValue* value, bool editable, LessonReader& reader) {
  if (value == nullptr) return std::nullopt;
  Reading& reading = reader.reading();
  JsonObject object(*value, words::kGoal, reading);
  Lab::Goal goal;
  goal.span = value->span;
  goal.text = reader.fragment(object.string("text"));
  goal.done = object.string("done");
  const JsonValue* solution = object.require(
      "solution", "nobody knows whether this goal can be reached: it has no \"solution\"",
      "add \"solution\": {\"run\": …, \"seconds\": …}");
  if (solution != nullptr) read_solution(*solution, editable, reading, goal);
  object.finish();
  if (goal.done.text.empty()) return std::nullopt;
  return goal;
}

bool read_editable(const JsonValue* value, LessonReader& reader, std::vector<Lab::Task>& tasks) {
  if (value == nullptr) return false;
  Reading& reading = reader.reading();
  if (value->kind == JsonValue::Kind::boolean) return value->boolean;
  if (value->kind != JsonValue::Kind::object) {
    report_kind("editable", *value, "true, or an object with \"tasks\"", reading);
    return false;
  }
  JsonObject object(*value, words::kEditable, reading);
  for (const JsonValue& item :
       object.list("tasks", "add a task: {\"q\": …, \"value\": …}, or write true")) {
    JsonObject of_task(item, words::kTask, reading);
    Lab::Task task;
    task.question = reader.fragment(of_task.string("q"));
    task.value = of_task.string("value");
    task.tolerance = of_task.number("tol", task.tolerance);
    task.unit = of_task.string("unit").text;
    of_task.finish();
    if (!task.value.text.empty()) tasks.push_back(std::move(task));
  }
  object.finish();
  return true;
}

}  // namespace mjcourse
