#include "physics/overlays.h"

#include <algorithm>
#include <span>

#include "base/nearest.h"
#include "physics/overlay_table.h"

namespace mjcourse {
namespace {

std::span<const mjcOverlay> table() {
  int count = 0;
  const mjcOverlay* overlays = mjc_overlays(&count);
  return {overlays, static_cast<std::size_t>(count)};
}

}  // namespace

std::vector<std::string> overlay_names() {
  std::vector<std::string> names;
  for (const mjcOverlay& overlay : table()) names.emplace_back(overlay.name);
  return names;
}

tl::expected<mjvOption, std::string> visual_options(const Overlays& overlays) {
  mjvOption option;
  mjv_defaultOption(&option);
  std::map<mjcOverlayKind, std::string> chosen;
  for (const auto& [name, on] : overlays) {
    const auto overlay = std::find_if(table().begin(), table().end(),
                                      [&](const mjcOverlay& o) { return o.name == name; });
    if (overlay == table().end()) {
      return tl::unexpected("there is no overlay `" + name + "`; " +
                            suggest(name, overlay_names()));
    }
    if (on && overlay->kind != mjcOVERLAY_FLAG) {
      const auto [other, first] = chosen.emplace(overlay->kind, name);
      if (!first) {
        return tl::unexpected("MuJoCo draws one kind of frame and one of label at a time: `" +
                              other->second + "` or `" + name + "`");
      }
    }
    mjc_set_overlay(&option, &*overlay, on);
  }
  return option;
}

std::vector<std::string> overlays_in(const mjvOption& option) {
  std::vector<std::string> names;
  for (const mjcOverlay& overlay : table()) {
    if (mjc_shows_overlay(&option, &overlay) != 0) names.emplace_back(overlay.name);
  }
  return names;
}

}  // namespace mjcourse
