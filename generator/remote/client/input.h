// Input: what comes to `mjcourse-net`: its settings, questions, and connections that it is given.
// Tested by tests/store/remote.mjs.
#pragma once

#include <deque>
#include <optional>

#include "base/descriptor.h"
#include "remote/frames.h"

namespace mjcourse {

class Input {
 public:
  // `in` is a socket.
  explicit Input(int in) : in_(in) {}

  // What can be read now; false at the end.
  bool read();
  // The next that is no connection.
  std::optional<Message> next();
  // Waits for the next connection, which was asked for; not open where there is none.
  Descriptor connection();

 private:
  int in_;
  FrameReader frames_;
  std::deque<Message> messages_;
  std::deque<Descriptor> passed_, connections_;
};

}  // namespace mjcourse
