// Parallel work: one function for many indices, on several threads.
//
// Enter with for_each_index. It is for work whose items are independent and whose results have a
// place of their own each, so that nothing depends on the number of threads or on which came first.
#pragma once

#include <cstddef>
#include <functional>

namespace mjcourse {

// The threads that the machine runs at once, at least 1.
std::size_t core_count();

// Call `work(index, thread)` once for each index below `count`, on at most `threads` threads, one
// of which is the caller's; the indices are taken in their order. `thread` is below `threads` and
// tells apart those that run at the same time, so that each can have tools of its own. Returns when
// all is done. What a call throws ends the work early: the exception of the lowest index is thrown
// here.
void for_each_index(std::size_t count, std::size_t threads,
                    const std::function<void(std::size_t index, std::size_t thread)>& work);

}  // namespace mjcourse
