// Regions: the parts of a program that lessons show by themselves.
//
// A region stands in its file between the lines `// #region NAME` and `// #endregion`. Readers
// never see these lines, nor the indentation that all of a region has.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "lesson/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// The region that `example` names, as a reader sees it; nothing (reported) where the file has no
// such region, or where the fence says something else.
std::optional<std::string> evaluate_region(const Example& example, const Lesson& lesson,
                                           const std::filesystem::path& root,
                                           Diagnostics& diagnostics);

// `code` without the lines that begin and end regions.
std::string without_region_marks(std::string_view code);

}  // namespace mjcourse
