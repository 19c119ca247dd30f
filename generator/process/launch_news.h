// What a child tells of its way to becoming a program, over a pair of sockets: first its id, then
// where its watcher is asked or why it could not begin. At the end of the stream it is the program.
#pragma once

#include <sys/types.h>

#include "base/descriptor.h"

namespace mjcourse {

// The child's side: async-signal-safe, and what cannot be told is lost.
void tell_id(int socket, pid_t id);
void tell_listener(int socket, int listener);
void tell_failure(int socket, int error);

struct LaunchNews {
  bool begun = false;                  // no more will come
  pid_t id = -1;                       // of the child
  int failure = 0;                     // errno; the program will not begin
  Descriptor listener = Descriptor();  // where its watcher is asked
};

// Waits for the next.
LaunchNews read_launch_news(int socket);

}  // namespace mjcourse
