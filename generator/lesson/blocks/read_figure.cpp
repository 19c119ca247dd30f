#include "lesson/blocks/read_figure.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "lesson/blocks/read_view.h"
#include "lesson/json/figure_vocabulary.h"
#include "lesson/json/json_object.h"

namespace mjcourse {
namespace {

// What all frames together may take before they become a film: 19 seconds of the usual size.
constexpr double kMostBytes = 1e9;
constexpr double kFrameBytes = 3 * 1.5 * 1.5;  // for each CSS pixel

void read_size(JsonObject& object, Figure& figure, Reading& reading) {
  const std::vector<JsonValue>& size = object.list("size");
  const JsonValue* value = object.find("size");
  if (value == nullptr || value->kind != JsonValue::Kind::array) return;
  const Limits& side = words::kFigure.find("size")->limits;
  const bool fits = size.size() == 2 && std::all_of(size.begin(), size.end(), [&](const auto& one) {
                      return one.kind == JsonValue::Kind::number && one.number >= side.least &&
                             one.number <= side.most && one.number == std::floor(one.number);
                    });
  if (!fits) {
    reading.error("E-json-range", value->span, "\"size\" " + std::string(side.text),
                  "as in [640, 400]");
    return;
  }
  figure.width = static_cast<int>(size[0].number);
  figure.height = static_cast<int>(size[1].number);
}

std::optional<Figure::Snapshot> read_snapshot(JsonObject& object, Reading& reading) {
  if (!object.has("from")) return std::nullopt;
  const LocatedText from = object.required_string("from");
  const std::size_t slash = from.text.find('/');
  if (slash != from.text.npos && slash > 0 && slash + 1 < from.text.size()) {
    return Figure::Snapshot{from.part(0, slash), from.part(slash + 1, from.text.size())};
  }
  if (!from.text.empty()) {
    reading.error("E-figure-from", from.span(), "\"from\" names an example and its snapshot",
                  "as in \"EXAMPLE/SNAPSHOT\"");
  }
  return std::nullopt;
}

// What a snapshot leaves no room for.
void refuse_beside_snapshot(JsonObject& object, Reading& reading) {
  for (const char* key : {"keyframe", "run", "seconds"}) {
    if (!object.has("from") || !object.has(key)) continue;
    reading.error(
        "E-figure-from", object.find(key)->span,
        "\"from\" is the state already: a figure with it has no \"" + std::string(key) + "\"",
        "let the example go on to the state that you mean, or leave out \"from\"");
  }
}

std::optional<Figure::Animation> read_animation(JsonObject& object, const Figure& figure,
                                                Reading& reading) {
  const JsonValue* value = object.find("animate");
  if (value == nullptr) return std::nullopt;
  JsonObject read(*value, words::kAnimation, reading);
  Figure::Animation animation;
  animation.span = {value->span.begin, value->span.begin + 1};
  animation.seconds = read.number("seconds", 0);
  animation.rate = read.whole("fps", animation.rate);
  read.finish();
  if (animation.seconds == 0) return std::nullopt;
  const double bytes = kFrameBytes * figure.width * figure.height * animation.frames();
  if (animation.frames() < 2 || bytes > kMostBytes) {
    const std::string size = std::to_string(figure.width) + " × " + std::to_string(figure.height);
    const bool one = animation.frames() < 2;
    reading.error("E-figure-frames", animation.span,
                  one ? "this animation is of one frame only"
                      : std::to_string(animation.frames()) + " frames of " + size +
                            " pixels are too many: unpacked they take " +
                            std::to_string(static_cast<int>(bytes / 1e6)) +
                            " MB, and 1000 MB is the most",
                  one ? "give it more \"seconds\" or \"fps\""
                      : "fewer \"seconds\" or \"fps\", or a smaller \"size\"");
    return std::nullopt;
  }
  return animation;
}

}  // namespace

int Figure::Animation::frames() const {
  return static_cast<int>(std::lround(seconds * rate));
}

std::optional<Figure> read_figure(Fence& fence, LessonReader& reader) {
  Reading& reading = reader.reading();
  fence.finish("figure", {}, reading);
  const std::optional<JsonValue> json = parse_json(fence.body(), reading);
  if (!json) return std::nullopt;
  JsonObject object(*json, words::kFigure, reading);
  Figure figure;
  figure.span = fence.span();
  figure.model = object.string("model");
  figure.camera = read_camera(object, reading);
  figure.overlays = read_overlays(object, reading);
  figure.keyframe = object.string("keyframe");
  figure.run = object.script("run");
  figure.seconds = object.number("seconds", 0);
  if (const JsonValue* seconds = object.find("seconds")) figure.seconds_span = seconds->span;
  figure.from = read_snapshot(object, reading);
  refuse_beside_snapshot(object, reading);
  read_size(object, figure, reading);
  figure.animation = read_animation(object, figure, reading);
  figure.caption = reader.fragment(object.string("caption"));
  figure.alt = read_alt(object, reading);
  figure.pin = read_pin(object, reading);
  object.finish();
  if (figure.model.text.empty()) return std::nullopt;
  return figure;
}

}  // namespace mjcourse
