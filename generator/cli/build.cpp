#include <iostream>
#include <string>
#include <utility>

#include "base/out_folder.h"
#include "base/utf8.h"
#include "cli/commands.h"
#include "cli/run.h"
#include "cli/verify.h"
#include "course/last_changed.h"
#include "evaluate/claims/claims.h"
#include "page/blocks/themed_assets.h"
#include "page/foreign_files.h"
#include "page/site.h"
#include "page/without_solutions.h"

namespace mjcourse {

int build(const BuildOptions& options) {
  Verified verified = verify_course(options);
  if (verified.failed) {
    std::cout << "no site was written: fix the errors first\n";
    return kCourseErrors;
  }
  History history = last_changed(options.course, "content");
  if (!history.unknown.empty()) {
    std::cout << "note: no page says when it was last changed: " << history.unknown << '\n';
  }
  if (!options.base_url.empty()) verified.course->url = options.base_url;
  if (options.without_solutions) withhold_solutions(*verified.course, verified.evaluation);
  const std::filesystem::path site = find_out_path(options.out, options.course).path;
  try {
    write_site(
        *verified.course, verified.evaluation,
        {options.course, assets_folder(), site, options.jobs, options.compress,
         !options.without_solutions},
        [&](const Lesson& lesson) { return claims_of_prose(lesson, verified.evaluation); },
        std::move(history.changes));
  } catch (const BrokenTemplate& broken) {
    const DiskFiles course(options.course);
    if (!is_themed(broken.error().name, course)) throw;
    print_diagnostics({template_mistake(broken.error(), course)});
    std::cout << "no site was written: fix the error first\n";
    return kCourseErrors;
  }
  std::string kept;
  for (const std::string& file : foreign_files(site)) {
    kept += (kept.empty() ? "" : ", ") + readable(file);
  }
  if (!kept.empty()) std::cout << "kept in the site, though no build wrote it: " << kept << '\n';
  std::cout << "site: " << options.out.lexically_normal().string() << "/index.html\n";
  return kClean;
}

}  // namespace mjcourse
