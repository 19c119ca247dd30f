#include <iostream>
#include <optional>
#include <string>

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

namespace {

class SiteBuild {
 public:
  explicit SiteBuild(const BuildOptions& options) : options_(options) {}

  int run() {
    // A site that was proved stays until all of the new one is. And solutions are taken out of what
    // was found, which is wanted whole until all is known.
    ShowNative show;
    is_previewed_ = std::filesystem::exists(site() / kProvisional);
    if (!options_.without_solutions &&
        (is_previewed_ || !std::filesystem::exists(site() / "index.html"))) {
      show = [this](Course& course, const Evaluation& evaluation) { preview(course, evaluation); };
    }
    Verified verified = verify_course(options_, show);
    if (verified.failed) return refuse("fix the errors first");
    if (options_.without_solutions) withhold_solutions(*verified.course, verified.evaluation);
    try {
      write(*verified.course, verified.evaluation, options_.compress);
    } catch (const BrokenTemplate& broken) {
      const DiskFiles course(options_.course);
      const std::string& name = broken.error().name;
      if (!name.empty() && !is_themed(name, course)) throw;
      print_diagnostics({template_mistake(broken.error(), course)});
      return refuse("fix the error first");
    }
    tell_of_foreign_files();
    std::cout << "site: " << index() << '\n';
    return kClean;
  }

 private:
  // What somebody can read while the rest is proved. Its templates are told of when all is known.
  void preview(Course& course, const Evaluation& evaluation) {
    try {
      write(course, evaluation, false);
    } catch (const BrokenTemplate&) {
      return;
    }
    is_previewed_ = true;
    std::cerr
        << "mjcourse: " << index()
        << " can be read; it is written again once its programs have run as its pages run them\n";
  }

  void write(Course& course, const Evaluation& evaluation, bool compress) {
    if (!history_) {
      history_ = last_changed(options_.course, "content");
      if (!history_->unknown.empty()) {
        std::cout << "note: no page says when it was last changed: " << history_->unknown << '\n';
      }
    }
    if (!options_.base_url.empty()) course.url = options_.base_url;
    write_site(
        course, evaluation,
        {options_.course, std::filesystem::absolute(assets_folder()), own_program(), site(),
         options_.jobs, compress, !options_.without_solutions},
        [&](const Lesson& lesson) { return claims_of_prose(lesson, evaluation); },
        history_->changes);
  }

  int refuse(const char* cure) const {
    std::cout << (is_previewed_ ? "the site lacks what programs are in its pages: "
                                : "no site was written: ")
              << cure << '\n';
    return kCourseErrors;
  }

  void tell_of_foreign_files() const {
    std::string kept;
    for (const std::string& file : foreign_files(site())) {
      kept += (kept.empty() ? "" : ", ") + readable(file);
    }
    if (kept.empty()) return;
    std::cout << "kept in the site, though no build wrote it: " << kept << '\n';
  }

  std::filesystem::path site() const { return find_out_path(options_.out, options_.course).path; }
  std::string index() const { return options_.out.lexically_normal().string() + "/index.html"; }

  const BuildOptions& options_;
  std::optional<History> history_;
  bool is_previewed_ = false;  // by this build, or by one that did not come to its end
};

}  // namespace

int build(const BuildOptions& options) {
  return SiteBuild(options).run();
}

}  // namespace mjcourse
