// Plain names: what a file or a folder is called that others get, in the site, in an archive or on
// a system of their own.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

// In bytes. A disk takes 255, and what a file is made into has a longer name:
// "-HASH.rehearsal.json" in the place of ".xml".
inline constexpr std::size_t kLongestName = 230;

// Why something is not a plain name.
struct NameFault {
  std::string name;  // of a path, the part that is at fault
  std::string why;   // "has a `:` in it, which no name on Windows has"

  // Both, to go on with in a sentence.
  std::string text() const;
};

// May it begin with a dot?
enum class Hidden { is_fault, is_allowed };

// A plain name is one step of a path and no more, is shown as it is, and is a name on Windows too.
std::optional<NameFault> fault_of_name(std::string_view name, Hidden hidden = Hidden::is_fault);
// The same of a path, whose parts are plain names.
std::optional<NameFault> fault_of_path(std::string_view path, Hidden hidden = Hidden::is_fault);

}  // namespace mjcourse
