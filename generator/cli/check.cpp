#include "cli/commands.h"
#include "cli/run.h"
#include "cli/verify.h"

namespace mjcourse {

int check(const Options& options) {
  return verify_course(options).failed ? kCourseErrors : kClean;
}

}  // namespace mjcourse
