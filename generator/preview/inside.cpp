#include "preview/inside.h"

#include <algorithm>

#include "base/files.h"

namespace mjcourse {
namespace fs = std::filesystem;

std::optional<std::string> read_inside(const fs::path& folder, const fs::path& path) {
  std::error_code unreadable;
  const fs::path inner = fs::canonical(path, unreadable);
  if (unreadable || !fs::is_regular_file(inner, unreadable)) return std::nullopt;
  const fs::path outer = fs::canonical(folder, unreadable);
  const auto [end, ignored] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  if (unreadable || end != outer.end()) return std::nullopt;
  const auto bytes = DiskFiles("").read(inner.string());
  return bytes ? std::optional(*bytes) : std::nullopt;
}

}  // namespace mjcourse
