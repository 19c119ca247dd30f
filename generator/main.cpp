// Tested by tests/courses.
#include <csignal>

#include "cli/run.h"
#include "process/group_killer.h"

// Read by jemalloc before main(). In large pages, memory that is new costs a short run less; what
// is large itself, a shadow map of 64 MB, jemalloc would give back at once, for the next one to be
// new.
extern "C" {
const char* malloc_conf = "thp:always,oversize_threshold:0";
}

int main(int argc, char** argv) {
  // A launcher may have it ignored, and then nobody learns how a program ended.
  std::signal(SIGCHLD, SIG_DFL);
  // While we are small, and alone.
  mjcourse::GroupKiller::instance();
  return mjcourse::run_command({argv + 1, argv + argc});
}
