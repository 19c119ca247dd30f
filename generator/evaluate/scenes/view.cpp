#include "evaluate/scenes/view.h"

#include <algorithm>

#include "base/nearest.h"

namespace mjcourse {

namespace {

// In motion three pixels for two of the page's look as sharp as four, at half the cost; and a film
// has an even number of them.
PictureSize size_of(const View& view) {
  const auto scaled = [&](int side) {
    return view.detail == Detail::film ? (3 * side + 3) / 4 * 2 : 2 * side;
  };
  return {scaled(view.width), scaled(view.height)};
}

}  // namespace

void check_overlays(const std::vector<LocatedText>& names, const BlockContext& context) {
  const std::vector<std::string> known = overlay_names();
  for (const LocatedText& name : names) {
    if (std::find(known.begin(), known.end(), name.text) != known.end()) continue;
    context.error("E-overlay-unknown", name.span(), "there is no overlay \"" + name.text + "\"",
                  suggest(name.text, known));
  }
}

std::vector<LocatedText> names_of(const std::vector<Lab::Overlay>& overlays) {
  std::vector<LocatedText> names;
  for (const Lab::Overlay& overlay : overlays) names.push_back(overlay.name);
  return names;
}

Overlays switched(const std::vector<Lab::Overlay>& overlays) {
  Overlays switched;
  for (const Lab::Overlay& overlay : overlays) switched[overlay.name.text] = overlay.on;
  return switched;
}

Lab::Camera camera_of(const std::optional<Lab::Camera>& camera, const WholeView& view) {
  if (camera) return *camera;
  const auto [target, distance] = view.place();
  return {view.outlook().azimuth, view.outlook().elevation, distance, target};
}

std::optional<Picture> draw(const Simulation& simulation, const View& view, const std::string& what,
                            Span blamed, const BlockContext& context) {
  const tl::expected<Renderer*, std::string> renderer = context.worker_context().renderer();
  if (!renderer) {
    context.error("E-picture", blamed, "no picture can be drawn: " + renderer.error());
    return std::nullopt;
  }
  const auto& [azimuth, elevation, distance, target] = view.camera;
  tl::expected<Picture, std::string> picture =
      (*renderer)->render(simulation, {azimuth, elevation, distance, target},
                          switched(view.overlays), size_of(view), view.detail);
  if (picture) return *std::move(picture);
  context.error("E-picture", blamed, what + " cannot be drawn: " + picture.error());
  return std::nullopt;
}

Poster poster_of(const Picture& picture, const View& view) {
  return {Blob(encode_webp(picture)), Blob(encode_png(picture)), view.width, view.height};
}

}  // namespace mjcourse
