// The command line: one small file for each command, and this way in.
//
// Exit codes: 0 all is well, 1 the course has errors, 2 the command line is wrong, 3 something
// failed that no author can mend (a disk, a missing asset, a mistake of ours).
#pragma once

#include <string>
#include <vector>

namespace mjcourse {

enum ExitCode { kClean = 0, kCourseErrors = 1, kWrongUsage = 2, kOurFault = 3 };

// `arguments` without the program's name.
int run_command(const std::vector<std::string>& arguments);

}  // namespace mjcourse
