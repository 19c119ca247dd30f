// ````demo: a piece of a lesson as it is written, and below it what it becomes.
//
// What stands in a demo is a part of its lesson like any other: its programs are run, its labs
// rehearsed, its answers proved. So a guide for authors that is made of demos cannot say what is
// no longer so. The walk that finds the fence (lesson_reader.h) goes on into its document.
#pragma once

#include "lesson/blocks/fence.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

// False (reported) where no demo can stand, or where it shows nothing.
bool check_demo(const Fence& fence, bool in_demo, Reading& reading);

}  // namespace mjcourse
