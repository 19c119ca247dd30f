#include "base/plain_name.h"

#include <algorithm>
#include <array>

#include "base/utf8.h"

namespace mjcourse {
namespace {

// Extension and case do not matter.
bool is_device(std::string_view name) {
  constexpr std::array kDevices{"con", "prn", "aux", "nul", "conin$", "conout$"};
  constexpr std::array kDigits{"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "¹", "²", "³"};
  std::string stem = lower_case_utf8(name.substr(0, name.find('.')));
  stem.erase(stem.find_last_not_of(' ') + 1);
  if (stem.starts_with("com") || stem.starts_with("lpt")) {
    return std::ranges::count(kDigits, stem.substr(3)) > 0;
  }
  return std::ranges::count(kDevices, stem) > 0;
}

// On a disk on which case does not matter, and under the short name that Windows gives it.
bool is_gits(std::string_view name) {
  const std::string small = lower_case_utf8(name);
  return small == ".git" || small == "git~1";
}

std::string why_not(std::string_view name, Hidden hidden) {
  if (name.empty()) return "is no name";
  if (name == ".") return "is the folder itself";
  if (name == "..") return "is the folder above";
  if (find_invalid_utf8(name)) return "is not UTF-8";
  if (readable(name) != name) return "has a control character in it";
  if (name.find('/') != name.npos) return "has a `/` in it, where the name of a folder ends";
  if (name.find('\\') != name.npos) return "has a `\\` in it, which is a `/` on Windows";
  if (const std::size_t at = name.find_first_of("<>:\"|?*"); at != name.npos) {
    return std::string("has a `") + name[at] + "` in it, which no name on Windows has";
  }
  if (is_gits(name)) return "is where git keeps what is its own";
  if (name.starts_with('.') && hidden == Hidden::is_fault)
    return "begins with a dot, so it is hidden";
  if (name.ends_with('.')) return "ends with a dot, which Windows leaves out";
  if (name.ends_with(' ')) return "ends with a blank, which Windows leaves out";
  if (is_device(name)) return "is a device on Windows";
  if (name.size() > kLongestName) return "has more than " + std::to_string(kLongestName) + " bytes";
  return "";
}

}  // namespace

std::string NameFault::text() const {
  return "`" + readable(name) + "` " + why;
}

std::optional<NameFault> fault_of_name(std::string_view name, Hidden hidden) {
  std::string why = why_not(name, hidden);
  if (why.empty()) return std::nullopt;
  return NameFault{std::string(name), std::move(why)};
}

std::optional<NameFault> fault_of_path(std::string_view path, Hidden hidden) {
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    if (auto fault = fault_of_name(path.substr(begin, end - begin), hidden)) return fault;
    begin = end + 1;
  }
  return std::nullopt;
}

}  // namespace mjcourse
