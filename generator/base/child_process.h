// A program from fork to its end, and its ends of the pipes.
//
// What happens between fork and exec is here; subprocess.cpp looks after the program from then on.
#pragma once

#include <sys/types.h>

#include "base/descriptor.h"
#include "base/subprocess.h"

namespace mjcourse {

class ChildProcess {
 public:
  // Forks. Throws std::system_error when the system has no room for another process.
  explicit ChildProcess(const Command& command);
  // Ends it, and waits for it.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t id() const { return id_; }

  // Its stdout and stderr, and what is readable when it has ended (-1 on a kernel without).
  Descriptor out, err, ended;
  // What it tells before it becomes the program; at the end of the stream it has become that.
  Descriptor news;
  struct News {
    bool begun = false;                  // no more will come
    int failure = 0;                     // errno; the program will not begin
    Descriptor listener = Descriptor();  // where its watcher is asked
  };
  News read_news();

  bool has_ended() const;
  // Kills it with its whole group, and waits until that is gone. Gives its status, as waitpid does.
  int end();

 private:
  pid_t id_ = -1;
  int status_ = 0;
};

}  // namespace mjcourse
