#include "lesson/blocks/read_view.h"

#include <algorithm>
#include <string_view>

#include "lesson/json/view_vocabulary.h"

namespace mjcourse {

std::optional<Lab::Camera> read_camera(JsonObject& object, Reading& reading) {
  const JsonValue* value = object.find("camera");
  if (value == nullptr) return std::nullopt;
  JsonObject read(*value, words::kCamera, reading);
  Lab::Camera camera;
  camera.azimuth = read.number("azimuth", camera.azimuth);
  camera.elevation = read.number("elevation", camera.elevation);
  camera.distance = read.number("distance", camera.distance);
  const std::vector<JsonValue>& target = read.list("target");
  for (std::size_t i = 0; i < target.size() && i < 3; ++i) camera.target[i] = target[i].number;
  const bool numbers = std::all_of(target.begin(), target.end(), [](const JsonValue& item) {
    return item.kind == JsonValue::Kind::number;
  });
  if (read.has("target") && (target.size() != 3 || !numbers)) {
    reading.error("E-json-range", read.find("target")->span,
                  "\"target\" is a point: three numbers, in metres");
  }
  read.finish();
  return camera;
}

std::vector<Lab::Overlay> read_overlays(JsonObject& object, Reading& reading) {
  std::vector<Lab::Overlay> overlays;
  const JsonValue* value = object.find("overlays");
  if (value == nullptr) return overlays;
  if (value->kind != JsonValue::Kind::object) {
    report_kind("overlays", *value, "an object: {\"frames\": true}", reading);
  }
  for (const JsonMember& member : value->members) {
    if (member.value.kind != JsonValue::Kind::boolean) {
      report_kind(member.key.text, member.value, "true or false", reading);
    }
    overlays.push_back({member.key, member.value.boolean});
  }
  return overlays;
}

std::string read_alt(JsonObject& object, Reading& reading) {
  const LocatedText alt = object.string("alt");
  if (!alt.text.empty() && alt.text.find_first_not_of(" \t\n") == alt.text.npos) {
    reading.error("E-json-missing", alt.span(), "\"alt\" is empty",
                  "say in a sentence what the picture shows");
  }
  return alt.text;
}

// It becomes a part of a file's name.
LocatedText read_pin(JsonObject& object, Reading& reading) {
  constexpr std::size_t kMostPin = 100;
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789-";
  if (!object.has("pin")) return {};
  LocatedText pin = object.required_string("pin");
  if (pin.text.find_first_not_of(letters) == pin.text.npos && pin.text.size() <= kMostPin) {
    return pin;
  }
  reading.error("E-pin-name", pin.span(),
                "\"pin\" names a picture's file: small letters, digits and hyphens, 100 at most",
                "as in \"arm-at-rest\"");
  return {};
}

LocatedText pin_of(const Block& block) {
  if (const auto* lab = std::get_if<Lab>(&block)) return lab->pin;
  if (const auto* figure = std::get_if<Figure>(&block)) return figure->pin;
  return {};
}

}  // namespace mjcourse
