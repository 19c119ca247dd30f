#include "cli/out_place.h"

#include <filesystem>

#include "base/beneath.h"
#include "cli/run.h"
#include "page/site_directory.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

std::optional<Refusal> refused_place(const fs::path& course, const fs::path& place,
                                     const std::string& option) {
  const auto name =
      name_beneath(fs::absolute(course).lexically_normal(), fs::absolute(place).lexically_normal());
  if (!name) return std::nullopt;  // elsewhere, as the user wants it
  const auto status = Beneath(course).status(*name);
  if (status || !status.error().is_refused()) return std::nullopt;
  return Refusal{kCourseErrors, *name + " " + status.error().why + ", so nothing is written there",
                 "name another place: `" + option + "`"};
}

// A site or a report takes its whole folder.
std::optional<Refusal> refused_folder(const fs::path& course, const fs::path& place,
                                      const std::string& option) {
  auto refused = refused_place(course, place, option);
  if (!refused) SiteDirectory::refuse_others(place);
  return refused;
}

}  // namespace

std::optional<Refusal> refused_out(const Options& options, std::string_view command) {
  std::optional<Refusal> refused;
  if (command == "build") {
    refused = refused_folder(options.course, options.out, "--out DIR");
  }
  if (!refused && !options.report.empty()) {
    refused = refused_folder(options.course, options.report, "--report DIR");
  }
  if (!refused && !options.trace.empty()) {
    refused = refused_place(options.course, options.trace, "--trace FILE");
    if (!refused && fs::exists(options.trace) && !fs::is_regular_file(options.trace)) {
      refused = Refusal{kWrongUsage, options.trace.string() + " is not a file",
                        "name a file: `--trace FILE`"};
    }
  }
  if (!refused && !options.store.empty()) {
    refused = refused_place(options.course, options.store, "--store DIR");
  }
  return refused;
}

}  // namespace mjcourse
