// Tested by tests/courses.
#include <iostream>

#include "cli/commands.h"
#include "cli/document.h"
#include "cli/run.h"
#include "cli/verify.h"

namespace mjcourse {

int check(const CheckOptions& options) {
  const Verified verified = verify_course(options);
  std::cout << document_of(verified, options);
  return verified.failed ? kCourseErrors : kClean;
}

}  // namespace mjcourse
