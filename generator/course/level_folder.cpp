#include "course/level_folder.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/utf8.h"

namespace mjcourse {
namespace {

// Of the files at a site's root.
constexpr std::array kEndings{".html", ".js", ".json", ".txt", ".xml"};

}  // namespace

std::optional<NameFault> fault_of_level_folder(const std::string& name) {
  if (auto fault = fault_of_name(name)) return fault;
  const std::string small = lower_case_utf8(name);
  if (small == kModelsFolder) return NameFault{name, "is where the site has the pages of models"};
  const auto* const ending =
      std::ranges::find_if(kEndings, [&](std::string_view one) { return small.ends_with(one); });
  if (ending == kEndings.end()) return std::nullopt;
  return NameFault{name, std::string("ends with `") + *ending + "`, as files of the site do"};
}

}  // namespace mjcourse
