// What a lab asks of its reader: to predict, to reach a goal, to find numbers for an edited model.
#pragma once

#include <optional>
#include <vector>

#include "lesson/blocks/lab.h"
#include "lesson/blocks/lesson_reader.h"
#include "lesson/json/json_object.h"

namespace mjcourse {

// Each of these gives nothing when its key is not there, or lacks what it cannot do without.
std::optional<Lab::Predict> read_predict(const JsonValue* value, LessonReader& reader);
// Reads `editable` of the lab first: only of an editable lab is a model a solution.
std::optional<Lab::Goal> read_goal(const JsonValue* value, bool editable, LessonReader& reader);
// `true`, or an object with tasks; `tasks` gets these. Gives whether the lab is editable.
bool read_editable(const JsonValue* value, LessonReader& reader, std::vector<Lab::Task>& tasks);

}  // namespace mjcourse
