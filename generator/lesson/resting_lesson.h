// Lessons at rest: what a course keeps of those that nobody works on.
//
// A course is read and checked as a whole before any of it is evaluated or written, and its trees
// take more memory than all else. So reading puts all lessons to rest but the first few hundred,
// and whoever writes a lesson wakes it, which reads it again. Of prose, which has nothing that
// evaluating looks at, only what other lessons need of it stays; so memory hardly depends on how
// many such lessons there are.
#pragma once

#include "base/files.h"
#include "lesson/blocks/lesson.h"

namespace mjcourse {

// Whether evaluating finds nothing to do in it, and no page explains what it links to.
bool is_prose(const Lesson& lesson);

// Drop the trees of `lesson`; where it is a card (Lesson::Kept), also its text and its blocks. Its
// links stay, for a course to look where they lead; see forget_links.
void put_to_rest(Lesson& lesson, Lesson::Kept kept);

// Once a course has looked at them, a card's links are of no use.
void forget_links(Lesson& lesson);

// The whole of a lesson at rest, whose file may have to be read again. Throws std::runtime_error
// when that is no longer what it was.
Lesson wake(const Lesson& resting, const Files& files);

}  // namespace mjcourse
