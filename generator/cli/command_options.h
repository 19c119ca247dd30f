// What each command takes on its command line.
// Tested by tests/generator/cli/run_test.cpp.
#pragma once

#include "cli/command_line.h"
#include "cli/commands.h"

namespace mjcourse {

void declare(CommandLine& line, AcceptOptions& options);
void declare(CommandLine& line, BuildOptions& options);
void declare(CommandLine& line, CheckOptions& options);
void declare(CommandLine& line, DoctorOptions& options);
void declare(CommandLine& line, ExplainOptions& options);
void declare(CommandLine& line, GradeOptions& options);
void declare(CommandLine& line, InitOptions& options);
void declare(CommandLine& line, ListOptions& options);
void declare(CommandLine& line, LspOptions& options);
void declare(CommandLine& line, NewOptions& options);
void declare(CommandLine& line, PreviewOptions& options);
void declare(CommandLine& line, StoreOptions& options);
void declare(CommandLine& line, TryOptions& options);

}  // namespace mjcourse
