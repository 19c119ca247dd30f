#include "preview/inside.h"

#include "base/files.h"

namespace mjcourse {
namespace fs = std::filesystem;

std::optional<std::string> read_inside(const fs::path& folder, const fs::path& path) {
  const auto bytes = read_beneath(folder, path);
  return bytes ? std::optional(*bytes) : std::nullopt;
}

}  // namespace mjcourse
