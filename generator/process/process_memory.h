// What another process means by the arguments of its system call.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>

namespace mjcourse {

// The text at `address` up to its NUL; errno where it cannot be read (EFAULT: there is none).
tl::expected<std::string, int> read_text(pid_t process, std::uint64_t address);
// Fills all of `into` from `address`; false where that cannot be read.
bool read_memory(pid_t process, std::uint64_t address, std::span<char> into);
std::optional<std::uint64_t> read_number(pid_t process, std::uint64_t address);

// The absolute path of `path`, which the process reckons from the folder of the descriptor `folder`
// (AT_FDCWD: from its working directory); nothing where that cannot be found out.
std::optional<std::string> absolute_path(pid_t process, int folder, const std::string& path);

// Is `thread` one of those of the process that `other` is a thread of?
bool shares_process(pid_t thread, pid_t other);

// How many threads it has; 0 when it has ended.
int count_threads(pid_t process);

}  // namespace mjcourse
