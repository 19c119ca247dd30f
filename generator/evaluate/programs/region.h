// Regions: the parts of a program that lessons show by themselves.
//
// A region stands in its file between the lines `// #region NAME` and `// #endregion`. Readers
// never see these lines, nor the indentation that all of a region has.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evaluate/context/shown_program.h"
#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// The region that `example` names, as a reader sees it; nothing (reported) where `program`, the
// text of the file, has no such region, or where the fence says something else. With `may_edit` the
// fence's lines may be put into the file, as they are in the program that was run; then they are
// what a reader sees.
std::optional<std::string> evaluate_region(const Example& example, const SourceText& program,
                                           bool may_edit, const Lesson& lesson,
                                           Diagnostics& diagnostics);

// The program `code` with the lines of the fences that show a region of it.
std::string with_shown_regions(std::string code, const ShownProgram& shown);

// `code` without the lines that begin and end regions; of an exercise, with its solution alone.
std::string as_shown(std::string_view code);

}  // namespace mjcourse
