// Tested by tests/courses.
#include <iostream>
#include <utility>

#include "cli/commands.h"
#include "cli/document.h"
#include "cli/run.h"
#include "cli/verify.h"

namespace mjcourse {

int check(const CheckOptions& options) {
  if (!options.shard.is_whole() && !options.report.empty()) {
    std::cerr
        << "mjcourse: a report tells of the whole course, and a shard knows its share alone\n"
           "leave out --report here, and write it in the run that comes last, without --shard\n";
    return kWrongUsage;
  }
  Verified verified = verify_course(options);
  std::cout << document_of(verified, options);
  // The process ends here, and its memory with it: to take a course apart costs a twentieth of a
  // check that has nothing to do.
  [[maybe_unused]] static const auto* const kept = new auto(std::move(verified.course));
  return verified.failed ? kCourseErrors : kClean;
}

}  // namespace mjcourse
