// What the fence of an output becomes when what its program printed is accepted.
#pragma once

#include <vector>

#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"
#include "report/line_diff.h"

namespace mjcourse {

// `changes` as output_changes gives them. A stated line that agrees stays as it is, to the byte;
// each new one gets what its neighbours have in front: the marks of quotes, the indentation of
// lists. Where a line looks like the fence's end, the fence becomes longer.
Edit output_edit(const Output& output, const std::vector<DiffLine>& changes, const Lesson& lesson);

}  // namespace mjcourse
