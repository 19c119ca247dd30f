#include "evaluate/scenes/image_size.h"

#include <webp/decode.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "base/xml_reader.h"

namespace mjcourse {
namespace {

constexpr int kLargest = 100000;  // pixels of a side; more is a broken file

// A big-endian number of `count` bytes; 0 past the end.
std::uint32_t number_at(const std::string& bytes, std::size_t at, std::size_t count) {
  std::uint32_t number = 0;
  for (std::size_t i = at; i < at + count; ++i) {
    number = number << 8 | (i < bytes.size() ? static_cast<std::uint8_t>(bytes[i]) : 0);
  }
  return number;
}

std::optional<ImageSize> checked(double width, double height) {
  const bool sensible = width >= 1 && height >= 1 && width <= kLargest && height <= kLargest;
  if (!sensible) return std::nullopt;
  return ImageSize{static_cast<int>(std::lround(width)), static_cast<int>(std::lround(height))};
}

std::optional<ImageSize> png_size(const std::string& bytes) {
  if (!bytes.starts_with("\x89PNG\r\n\x1a\n") || bytes.find("IHDR") != 12) return std::nullopt;
  return checked(number_at(bytes, 16, 4), number_at(bytes, 20, 4));
}

// A JPEG is a row of segments, each with its length; the size is in the one that opens the frame.
std::optional<ImageSize> jpeg_size(const std::string& bytes) {
  if (!bytes.starts_with("\xff\xd8")) return std::nullopt;
  for (std::size_t at = 2; at + 9 < bytes.size() && bytes[at] == '\xff';) {
    const std::uint32_t marker = number_at(bytes, at + 1, 1);
    const bool frame =
        marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (frame) return checked(number_at(bytes, at + 7, 2), number_at(bytes, at + 5, 2));
    if (marker == 0xDA) break;  // the picture itself
    at += marker == 0xFF ? 1 : 2 + number_at(bytes, at + 2, 2);
  }
  return std::nullopt;
}

std::optional<ImageSize> webp_size(const std::string& bytes) {
  int width = 0, height = 0;
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  if (WebPGetInfo(data, bytes.size(), &width, &height) == 0) return std::nullopt;
  return checked(width, height);
}

// A number alone or of pixels; 0 for "100%", "12cm" and the like.
double pixels(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const std::string unit = end;
  return unit.empty() || unit == "px" ? value : 0;
}

// What the first element of an SVG says of its size, and no more of it.
class SvgSize : public XmlReader {
 public:
  using XmlReader::XmlReader;

  std::optional<ImageSize> size() {
    read();
    if (const auto size = checked(pixels(width_), pixels(height_))) return size;
    std::ranges::replace(box_, ',', ' ');
    double values[4] = {};
    const char* at = box_.c_str();
    for (double& value : values) {
      char* end = nullptr;
      value = std::strtod(at, &end);
      at = end;
    }
    return checked(values[2], values[3]);
  }

 private:
  void begin(const XmlElement& element) override {
    stop();
    if (element.name.local != "svg") return;
    for (const XmlAttribute& attribute : element.attributes) {
      const std::string name = attribute.name.text();
      if (name == "width") width_ = attribute.value;
      if (name == "height") height_ = attribute.value;
      if (name == "viewBox") box_ = attribute.value;
    }
  }

  std::string width_, height_, box_;
};

}  // namespace

tl::expected<ImageSize, std::string> image_size(const std::string& name, const std::string& bytes) {
  const auto or_else = [](std::optional<ImageSize> size,
                          const char* error) -> tl::expected<ImageSize, std::string> {
    return size ? tl::expected<ImageSize, std::string>(*size) : tl::unexpected(std::string(error));
  };
  if (name.ends_with(".png")) return or_else(png_size(bytes), "is not a PNG");
  if (name.ends_with(".webp")) return or_else(webp_size(bytes), "is not a WebP");
  if (name.ends_with(".svg")) {
    return or_else(SvgSize(bytes).size(),
                   "is not an SVG that states its size by width and height in "
                   "pixels or by its viewBox");
  }
  return or_else(jpeg_size(bytes), "is not a JPEG");
}

}  // namespace mjcourse
