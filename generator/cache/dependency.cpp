#include "cache/dependency.h"

namespace mjcourse {

namespace fs = std::filesystem;

std::string file_dependency(const fs::path& path, const fs::path& root) {
  const fs::path whole = (root / path).lexically_normal();
  const fs::path below = whole.lexically_relative(root);
  const bool inside = !below.empty() && *below.begin() != "..";
  return (inside ? below : whole).string();
}

}  // namespace mjcourse
