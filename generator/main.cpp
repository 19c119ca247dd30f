#include <csignal>

#include "cli/run.h"

// Read by jemalloc before main(). In large pages, memory that is new costs a short run less.
extern "C" {
const char* malloc_conf = "thp:always";
}

int main(int argc, char** argv) {
  // A launcher may have it ignored, and then nobody learns how a program ended.
  std::signal(SIGCHLD, SIG_DFL);
  return mjcourse::run_command({argv + 1, argv + argc});
}
