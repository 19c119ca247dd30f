// A descriptor on its way from one process to another, over a socket between them.
// Tested by tests/generator/remote/passed_descriptor_test.cpp.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string_view>

#include "base/descriptor.h"

namespace mjcourse {

// Sends `bytes`, and with the first of them the descriptor where it is open. How many were sent, or
// -1 with errno.
ssize_t send_with(int socket, std::string_view bytes, const Descriptor& passed);

struct Received {
  ssize_t count = 0;  // bytes; -1 with errno
  Descriptor passed = Descriptor();
};

// What can be read now, into `bytes`.
Received receive_with(int socket, char* bytes, std::size_t size);

}  // namespace mjcourse
