// Steps: find the lessons that are meant; evaluate the course; gather the edits of those lessons'
// diagnostics; show each as a diff, and write it; tell what is left. A diagnostic carries an edit
// only where what was computed came out well.
// Tested by tests/accept.
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "base/beneath.h"
#include "base/counted.h"
#include "base/replace_file.h"
#include "base/utf8.h"
#include "cli/commands.h"
#include "cli/edit_text.h"
#include "cli/run.h"
#include "cli/verify.h"
#include "cli/where.h"
#include "report/colours.h"
#include "report/file_edits.h"

namespace mjcourse {
namespace {

class Acceptance {
 public:
  Acceptance(const AcceptOptions& options, const Verified& verified, std::vector<Where> where)
      : options_(options), verified_(verified), where_(std::move(where)) {}

  int run() {
    for (const Where& where : where_) tell_if_nothing(where);
    std::vector<const Diagnostic*> wanted;
    for (const Diagnostic& diagnostic : verified_.evaluation.diagnostics) {
      if (diagnostic.edit && is_meant(diagnostic)) wanted.push_back(&diagnostic);
    }
    const FileEdits edits = gather_edits(wanted, DiskFiles(options_.course));
    refused_ = edits.refused;
    for (const FileEdit& edit : edits.files) take(edit);
    print_diagnostics(left());
    return tell();
  }

 private:
  bool is_meant(const Diagnostic& diagnostic) const {
    return where_.empty() || std::any_of(where_.begin(), where_.end(), [&](const Where& where) {
             return where.has(diagnostic.place);
           });
  }

  // A line that has nothing to accept is most often the line beside the one that was meant.
  void tell_if_nothing(const Where& where) const {
    if (where.line == 0) return;
    const Diagnostic* nearest = nullptr;
    const auto distance = [&](const Diagnostic& one) {
      return std::abs(one.place.line - where.line);
    };
    for (const Diagnostic& one : verified_.evaluation.diagnostics) {
      if (!one.edit || one.place.file != where.lesson->source->path()) continue;
      if (where.has(one.place)) return;
      if (nearest == nullptr || distance(one) < distance(*nearest)) nearest = &one;
    }
    std::cout << where.lesson->source->path() << ":" << where.line << ": nothing to accept here; "
              << (nearest == nullptr
                      ? "nor anywhere in this lesson"
                      : "the nearest is line " + std::to_string(nearest->place.line) + ", " +
                            nearest->edit->what)
              << '\n';
  }

  void take(const FileEdit& edit) {
    std::cout << edit_text(edit, wants_colours(STDOUT_FILENO)) << '\n' << std::flush;
    if (!options_.dry_run && !write(edit)) {
      for (const Diagnostic* cure : edit.cures) {
        refused_.push_back({cure, changed_meanwhile(edit.file)});
      }
      return;
    }
    differences_ += edit.cures.size();
    ++files_;
  }

  bool write(const FileEdit& edit) {
    try {
      return replace_file(options_.course, edit.file, edit.before, edit.after);
    } catch (const RefusedPath& refused) {
      std::cout << refused.what() << ", so it was not written\n";
      return false;
    }
  }

  // What is wrong with the lessons that are meant and no edit mends, and what could not be written.
  Diagnostics left() const {
    Diagnostics left;
    for (const Diagnostic& one : verified_.evaluation.diagnostics) {
      const auto refused =
          std::find_if(refused_.begin(), refused_.end(),
                       [&](const RefusedEdit& edit) { return edit.diagnostic == &one; });
      if (refused != refused_.end()) {
        left.push_back(one);
        left.back().cure = refused->cure;
      } else if (!one.edit && concerns_what_is_meant(one)) {
        left.push_back(one);
      }
    }
    return left;
  }

  // An error in a lesson that is meant, or in a file that it uses.
  bool concerns_what_is_meant(const Diagnostic& diagnostic) const {
    return where_.empty() || std::any_of(where_.begin(), where_.end(), [&](const Where& where) {
             return concerns(diagnostic, where.lesson->source->path());
           });
  }

  int tell() const {
    const Diagnostics left = this->left();
    const auto errors =
        static_cast<std::size_t>(std::count_if(left.begin(), left.end(), [](const Diagnostic& one) {
          return one.severity == Severity::error;
        }));
    const std::string what =
        counted(differences_, "difference") + (files_ > 0 ? " in " + counted(files_, "file") : "");
    std::cout << (files_ == 0        ? "nothing to accept"
                  : options_.dry_run ? what + " to accept; nothing was written"
                                     : "accepted " + what)
              << (errors > 0 ? "; " + counted(errors, "error") + " to fix by hand" : "") << '\n';
    return errors > 0 || (options_.dry_run && files_ > 0) ? kCourseErrors : kClean;
  }

  const AcceptOptions& options_;
  const Verified& verified_;
  std::vector<Where> where_;
  std::vector<RefusedEdit> refused_;
  std::size_t differences_ = 0, files_ = 0;
};

}  // namespace

int accept(const AcceptOptions& options) {
  Verified verified = read_course_of(options);
  std::vector<Where> where;
  for (const std::string& text : options.where) {
    if (!verified.course) break;
    const auto place = find_place(*verified.course, options.course, text);
    if (!place) {
      std::cerr << "mjcourse: " << readable(place.error()) << '\n';
      return kWrongUsage;
    }
    where.push_back(*place);
  }
  evaluate_course(options, verified, false);
  return Acceptance(options, verified, std::move(where)).run();
}

}  // namespace mjcourse
