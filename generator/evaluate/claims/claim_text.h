// The words for how claims were found out, and how far; phrases without a full stop.
#pragma once

#include <string>

#include "findings/result.h"
#include "findings/versions.h"
#include "lesson/blocks/lesson.h"

namespace mjcourse {

// `text` on one line, cut at a word where it is longer than a title is.
std::string as_title(const std::string& text);

std::string how_run(const Example& program, const Versions& versions);
std::string how_run(const Commands& commands);
std::string how_tried(const ExerciseResult& result);
std::string how_run(const Snippet& snippet, const Versions& versions);
std::string how_run_in_page();
std::string limits_of_run(double seconds);

// `printed_by` is the program, or "the snippet above".
std::string how_compared(const Output& output, const OutputResult& result,
                         const std::string& printed_by);

std::string how_rehearsed(const Lab& lab, const LabResult& result);

std::string how_drawn(const Figure& figure, const Versions& versions);
std::string how_plotted(const Plot& plot, const PlotResult& result);

std::string how_proved(const Question& question, const QuestionResult& result);
std::string limits_of_answer(const Question& question);

}  // namespace mjcourse
