// What `check --strict` does not let pass: whatever nobody proved and nobody gave a reason for, and
// what is shown to those alone who can see it.
#pragma once

#include "evaluate/claim.h"
#include "lesson/lesson.h"

namespace mjcourse {

// An error for each claim that is asserted or unchecked without a reason.
Diagnostics unreasoned(const Claims& claims);

// An error for each lab that does not say in words what it shows. (Other pictures have to, always.)
Diagnostics undescribed(const Lesson& lesson);

}  // namespace mjcourse
