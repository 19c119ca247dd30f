// Makes MuJoCo's errors and warnings fit for programs that nobody watches.
// Linked into every example; there is nothing to call.
//
// By itself, MuJoCo 2.2.2 answers a fatal error by writing MUJOCO_LOG.TXT and
// waiting for somebody to press Enter, and a warning by writing to that log.
// Here both go to stderr, and an error ends the program with status 70
// (EX_SOFTWARE of sysexits.h): an error handler must never return, and an
// exception could not travel back through MuJoCo's C code.
#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>

namespace {

[[noreturn]] void on_error(const char* message) {
  std::fflush(stdout);
  std::fprintf(stderr, "MuJoCo error: %s\n", message);
  std::exit(70);
}

void on_warning(const char* message) {
  std::fprintf(stderr, "MuJoCo warning: %s\n", message);
}

// Constructed before main begins.
const struct Handlers {
  Handlers() {
    mju_user_error = on_error;
    mju_user_warning = on_warning;
  }
} handlers;

}  // namespace
