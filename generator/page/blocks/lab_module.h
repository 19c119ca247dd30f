// The module of a lab: what the page's script gets of it (site/browser/lab/lab-module.ts).
//
// Enter with write_lab_module(). The module's name has a hash of its content, so browsers may keep
// it for ever; its models are files of their own, which labs share.
#pragma once

#include <string>

#include "findings/result.h"
#include "lesson/blocks/lab.h"
#include "page/blocks/lesson_context.h"

namespace mjcourse {

// `name` is that of the lab in the course: "1.2-1". `context` makes HTML of its texts.
LabFiles write_lab_module(const Lab& lab, const LabResult& result, const std::string& name,
                          const LessonContext& context);

}  // namespace mjcourse
