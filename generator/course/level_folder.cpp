#include "course/level_folder.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/utf8.h"

namespace mjcourse {
namespace {

constexpr std::array<std::string_view, 11> kEndings{
    ".br", ".csv", ".gz", ".html", ".js", ".json", ".png", ".txt", ".webp", ".xml", ".zip"};

}  // namespace

bool ends_as_a_file(const std::string& folder) {
  const std::string small = lower_case_utf8(folder);
  return std::ranges::any_of(kEndings, [&](std::string_view one) { return small.ends_with(one); });
}

std::optional<NameFault> fault_of_level_folder(const std::string& name) {
  if (auto fault = fault_of_name(name)) return fault;
  if (lower_case_utf8(name) == "models") {
    return NameFault{name, "is where the site has the pages of models"};
  }
  if (ends_as_a_file(name)) return NameFault{name, "ends as a file of the site does"};
  return std::nullopt;
}

}  // namespace mjcourse
