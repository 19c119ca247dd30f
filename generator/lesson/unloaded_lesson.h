// Unloaded lessons: what a course keeps of those that nobody works on.
//
// A course is read and checked as a whole before any of it is evaluated or written, and its trees
// take more memory than all else. So reading unloads all lessons but the first few hundred. The
// writer of a lesson reloads it, which reads it again. Of prose, which has nothing that evaluating
// looks at, only an outline stays: what other lessons need of it. So memory hardly depends on how
// many such lessons there are.
#pragma once

#include "base/files.h"
#include "lesson/blocks/lesson.h"

namespace mjcourse {

// Whether evaluating finds nothing to do in it, and no page explains what it links to.
bool is_prose(const Lesson& lesson);

// Drop the trees of `lesson`; where only its outline is kept, also its text and its blocks. Its
// links stay, for a course to look where they lead; see forget_links.
void unload(Lesson& lesson, Lesson::Kept kept);

// Once a course has looked at them, an outline's links are of no use.
void forget_links(Lesson& lesson);

// The whole of an unloaded lesson, whose file may have to be read again. Throws std::runtime_error
// when that is no longer what it was.
Lesson reload(const Lesson& unloaded, const Files& files);

}  // namespace mjcourse
