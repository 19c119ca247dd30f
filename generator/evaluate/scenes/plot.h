// Plots: what the spec of a ```plot makes of a table that an example reported.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "evaluate/context/worker_context.h"
#include "findings/result.h"
#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// The plot at `index` of the lesson's blocks, drawn; the program's file is not known yet. Nothing
// when its table is not there, or the spec is not well made; it is reported, but for a table whose
// example failed, which was.
std::optional<PlotResult> evaluate_plot(const Plot& plot, std::size_t index, const Lesson& lesson,
                                        WorkerContext& worker_context, Diagnostics& diagnostics);

// Do they hold what draws alone, also where a browser reads them as a part of a page? `name` is the
// block's, with which their ids begin.
bool are_plain(const PlotDrawings& drawings, const std::string& name);

// "examples/x.cpp" of the example `name`, wherever the course shows it.
std::string file_of_example(const std::string& name, const Course& course);

}  // namespace mjcourse
