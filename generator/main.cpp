#include <csignal>

#include "cli/run.h"

int main(int argc, char** argv) {
  // A launcher may have it ignored, and then nobody learns how a program ended.
  std::signal(SIGCHLD, SIG_DFL);
  return mjcourse::run_command({argv + 1, argv + argc});
}
