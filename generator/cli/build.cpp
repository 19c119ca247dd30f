#include <iostream>

#include "cli/commands.h"
#include "cli/run.h"
#include "cli/verify.h"
#include "page/site.h"

namespace mjcourse {

int build(const Options& options) {
  const Verified verified = verify_course(options);
  if (verified.failed) {
    std::cout << "no site was written: mend the errors first\n";
    return kCourseErrors;
  }
  write_site(
      *verified.course, verified.evaluation,
      {options.course, assets_folder(), std::filesystem::absolute(options.out), options.jobs});
  std::cout << "site: " << options.out.lexically_normal().string() << "/index.html\n";
  return kClean;
}

}  // namespace mjcourse
