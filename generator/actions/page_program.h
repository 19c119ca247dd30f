// A program, compiled and run as a reader's page does it: by the page's compiler and engine.
//
// Enter at run_page_program(). All that such a program can read is in its question, so that is all
// it depends on beside the page's toolchain.
// Tested by tests/generator/evaluate/programs/page_run_test.cpp.
#pragma once

#include <map>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "actions/action_store.h"
#include "process/subprocess.h"
#include "toolchain/page_process.h"

namespace mjcourse {

// As a reader has it.
struct PageProgram {
  std::string main;                          // the file with main()
  std::map<std::string, std::string> files;  // with their bytes; models are in "models/"
  std::vector<std::string> arguments;
};

struct PageEnd {
  std::string refusal;  // the compiler's first error; then the rest is empty
  std::string how;      // "exit", "error", "uncaught", "memory", … (site/browser/cpp/messages.ts)
  int code = 0;         // of an exit
  int line = 0;         // of the program's source, where that is known
  std::string message;
  std::string out, records;

  bool compiled() const { return refusal.empty(); }
};

// In `process`, which is of `toolchain`; not more than `seconds`. Or how the process ended without
// an answer, which is never kept. Throws as PageProcess::ask().
tl::expected<PageEnd, Outcome> run_page_program(const PageProgram& program, double seconds,
                                                const PageToolchain& toolchain,
                                                PageProcess& process, ActionStore& store,
                                                Trace& trace);

}  // namespace mjcourse
