#include "output_changes.h"

#include <optional>
#include <string>
#include <string_view>

#include "evaluate/programs/output_diff.h"

const char* mjc_output_changes(const char* stated, int stated_size, const char* real, int real_size,
                               double tolerance) {
  using mjcourse::DiffLine;
  static std::string text;
  mjcourse::Retrials retrials;
  int gone = 0, come = 0;
  std::string numbers;
  for (const DiffLine& change : mjcourse::output_changes(
           {stated, static_cast<std::size_t>(stated_size)},
           {real, static_cast<std::size_t>(real_size)},
           tolerance < 0 ? std::nullopt : std::optional(tolerance), retrials)) {
    if (change.kind == DiffLine::Kind::gone) {
      ++gone;
    } else {
      // Its number counts the lines of `stated`.
      numbers += " " + std::to_string(change.line - gone + come);
      ++come;
    }
  }
  text = std::to_string(gone) + numbers;
  return text.c_str();
}
