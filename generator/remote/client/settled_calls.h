// System calls that a program gives up by itself, before it reads what anybody sent.
//
// Whoever starts a program cannot take from it to become another one, since it becomes itself so.
// Tested by tests/generator/remote/http_client_test.cpp.
#pragma once

#include <sys/syscall.h>

#include <cerrno>
#include <initializer_list>

namespace mjcourse {

struct SettledCall {
  int number;
  int error;  // with which it ends; 0 for a success of which nothing comes
};

inline constexpr std::initializer_list<SettledCall> kNoPrograms{{SYS_execve, EPERM},
                                                                {SYS_execveat, EPERM}};

// From now on, for this thread and all to come. Throws std::system_error.
void settle_calls(std::initializer_list<SettledCall> calls);

}  // namespace mjcourse
