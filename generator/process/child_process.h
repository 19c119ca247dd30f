// A program from its start to its end, and our ends of its pipes.
//
// How it starts is launch.h's; process_supervisor.cpp looks after it from then on.
// Tested by tests/generator/process/subprocess_test.cpp.
#pragma once

#include <sys/types.h>

#include <semaphore>
#include <thread>

#include "base/descriptor.h"
#include "process/launch_news.h"
#include "process/subprocess.h"

namespace mjcourse {

class ChildProcess {
 public:
  // The command must stay as long as this does. Throws std::system_error when the system has no
  // room for another process.
  explicit ChildProcess(const Command& command);
  // Ends it, and waits for it.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t id() const { return id_; }

  // Its stdout and stderr, and what is readable when it has ended (-1 on a kernel without).
  Descriptor out, err, ended;
  // Its stdin, where it answers or is heard: a socket, to which is written without waiting.
  Descriptor in;
  // What it tells before it becomes the program: somebody must read it.
  Descriptor news;

  bool has_ended() const;
  // Kills it with its whole group, and waits until that is gone. Gives its status, as waitpid does.
  int end();

 private:
  pid_t id_ = -1;
  int status_ = 0;
  std::binary_semaphore gone_{0};
  std::jthread parent_;  // which the kernel takes for it
};

}  // namespace mjcourse
