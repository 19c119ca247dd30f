// Try in a child what may crash, hang or take all memory, before doing it for good.
//
// For libraries that work in our own process on what an author wrote. The child is a copy of ours
// and does the work with limits on its memory and its time; nothing of it stays but how it ended.
#pragma once

#include <cstdint>
#include <functional>

namespace mjcourse {

enum class Attempt { done, too_much_memory, too_long, crashed };

// `work` is done when it returns; std::bad_alloc means that memory was short. It must need no lock
// that another of our threads may hold at this moment. It may use `bytes` of memory beyond what the
// process has; memory that it asks for and never touches does not count.
Attempt attempt(const std::function<void()>& work, std::uint64_t bytes, double seconds);

}  // namespace mjcourse
