#include "cli/out_place.h"

#include <filesystem>

#include "base/beneath.h"
#include "cli/run.h"

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

}  // namespace

std::optional<Refusal> refused_out(const Options& options, std::string_view command,
                                   bool out_was_named) {
  std::optional<Refusal> refused;
  if (command == "build") {
    const fs::path out = fs::absolute(options.out).lexically_normal();
    refused = refused_place(options.course, out_was_named ? out.parent_path() : out, "--out DIR");
  }
  if (!refused && !options.report.empty()) {
    const fs::path report = fs::absolute(options.report).lexically_normal();
    refused = refused_place(options.course, report.parent_path(), "--report DIR");
  }
  if (!refused && !options.trace.empty()) {
    refused = refused_place(options.course, options.trace, "--trace FILE");
  }
  return refused;
}

}  // namespace mjcourse
