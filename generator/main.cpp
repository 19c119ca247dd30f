#include "cli/run.h"

int main(int argc, char** argv) {
  return mjcourse::run_command({argv + 1, argv + argc});
}
