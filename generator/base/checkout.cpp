#include "base/checkout.h"

namespace mjcourse {

namespace fs = std::filesystem;

std::optional<fs::path> checkout_of(const fs::path& folder) {
  std::error_code none;
  for (fs::path above = fs::weakly_canonical(folder, none); !above.empty();
       above = above.parent_path()) {
    // A folder, or a file that names one elsewhere, as of a work tree and of a submodule.
    if (fs::exists(fs::symlink_status(above / ".git", none))) return above;
    if (above == above.root_path()) break;
  }
  return std::nullopt;
}

}  // namespace mjcourse
