#include "cli/out_place.h"

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string>

#include "base/beneath.h"
#include "base/out_folder.h"
#include "cli/run.h"
#include "page/foreign_files.h"
#include "page/site_directory.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// In the course's checkout, each link and folder may be of a stranger's change.
std::optional<Refusal> refused_place(const fs::path& course, const fs::path& place,
                                     const std::string& option) {
  const OutPath found = find_out_path(place, course);
  if (found.inside.empty()) return std::nullopt;  // elsewhere, as the user wants it
  const auto refuse = [&](const std::string& what) {
    return Refusal{kCourseErrors, what + ", so nothing is written there",
                   "name another place: `" + option + "`"};
  };
  if (found.is_link) return refuse(found.shown + " is a link");
  const auto status = Beneath(found.root).status(found.inside);
  if (status || !status.error().is_refused()) return std::nullopt;
  return refuse(found.shown + " " + status.error().why);
}

// Before a course is worked on for minutes: may this user write what comes to lie at `place`? What
// is there already is replaced, so what counts is the folder that it lies in, or will.
std::optional<Refusal> refused_by_system(const fs::path& place, const std::string& option) {
  std::error_code none;
  fs::path above = fs::weakly_canonical(fs::absolute(place), none).parent_path();
  while (!fs::exists(above, none) && above.has_relative_path()) above = above.parent_path();
  const bool is_folder = fs::is_directory(above, none);
  if (is_folder && eaccess(above.c_str(), W_OK | X_OK) == 0) return std::nullopt;
  const std::error_code why(is_folder ? errno : ENOTDIR, std::generic_category());
  return Refusal{kWrongUsage,
                 place.string() + " cannot be written: " + above.string() + ": " + why.message(),
                 (is_folder ? "allow this user to write there, or name another place: `"
                            : "name another place: `") +
                     option + "`"};
}

// A site or a report takes its whole folder.
std::optional<Refusal> refused_folder(const fs::path& course, const fs::path& place,
                                      const std::string& option) {
  auto refused = refused_place(course, place, option);
  const fs::path path = find_out_path(place, course).path;
  if (!refused && name_beneath(path, fs::weakly_canonical(course))) {
    return Refusal{kWrongUsage,
                   "the course lies in " + place.string() + ", which would be replaced",
                   "name another place: `" + option + "`"};
  }
  if (!refused) SiteDirectory::refuse_others(path);
  if (!refused) refuse_unmovable_files(path);
  if (!refused) refused = refused_by_system(place, option);
  return refused;
}

}  // namespace

std::optional<Refusal> refused_out(const OutPlaces& places) {
  std::optional<Refusal> refused;
  if (!places.site.empty()) {
    refused = refused_folder(places.course, places.site, "--out DIR");
  }
  if (!refused && !places.report.empty()) {
    refused = refused_folder(places.course, places.report, "--report DIR");
  }
  if (!refused && !places.trace.empty()) {
    refused = refused_place(places.course, places.trace, "--trace FILE");
    if (!refused && fs::exists(places.trace) && !fs::is_regular_file(places.trace)) {
      refused = Refusal{kWrongUsage, places.trace.string() + " is not a file",
                        "name a file: `--trace FILE`"};
    }
    if (!refused) refused = refused_by_system(places.trace, "--trace FILE");
  }
  if (!refused && !places.store.empty()) {
    refused = refused_place(places.course, places.store, "--store DIR");
    // One that is there may be there to be read.
    if (!refused && !fs::exists(places.store)) {
      refused = refused_by_system(places.store, "--store DIR");
    }
  }
  if (!refused && !places.exercise.empty()) {
    refused = refused_place(places.course, places.exercise, "--out DIR");
  }
  return refused;
}

Refusal failed_call(const std::system_error& error) {
  const auto* of_file = dynamic_cast<const fs::filesystem_error*>(&error);
  const std::string message =
      of_file == nullptr ? error.what() : of_file->path1().string() + ": " + error.code().message();
  switch (error.code().value()) {
    case ENOSPC:
    case EDQUOT:
      return {kOurFault, message, "make room on that disk; what was there before is as it was"};
    case EACCES:
    case EPERM:
    case EROFS:
      return {kOurFault, message, "allow this user to read and write it"};
    case EISDIR:
    case ENOTDIR:
      return {kCourseErrors, message,
              "one name is that of a file and of a folder: rename one of the two"};
    case ENAMETOOLONG:
      return {kCourseErrors, message, "choose a shorter name"};
    default:
      return {kOurFault, message, ""};
  }
}

}  // namespace mjcourse
