#include "evaluate/scenes/image_size.h"

#include <gtest/gtest.h>

#include "physics/picture.h"

namespace mjcourse {
namespace {

std::string size_of(const std::string& name, const std::string& bytes) {
  const auto size = image_size(name, bytes);
  return size ? std::to_string(size->width) + " x " + std::to_string(size->height) : size.error();
}

Picture picture(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height))};
}

// A JPEG's head: an APP0 segment, a quantization table, and the frame.
std::string jpeg(const std::string& frame) {
  const std::string app0("\xff\xe0\x00\x04JF", 6), table("\xff\xdb\x00\x03q", 5);
  return "\xff\xd8" + app0 + table + frame + std::string(16, 'x');
}

TEST(ImageSize, IsThatOfTheFile) {
  EXPECT_EQ(size_of("a.png", encode_png(picture(30, 7))), "30 x 7");
  EXPECT_EQ(size_of("a.webp", encode_webp(picture(30, 7))), "30 x 7");
  const std::string baseline("\xff\xc0\x00\x11\x08\x01\x00\x02\x03\x03", 10);
  EXPECT_EQ(size_of("a.jpg", jpeg(baseline)), "515 x 256");
  const std::string progressive("\xff\xc2\x00\x11\x08\x00\x10\x00\x20\x03", 10);
  EXPECT_EQ(size_of("a.jpeg", jpeg(progressive)), "32 x 16");
}

TEST(ImageSize, OfAnSvgIsWhatItSays) {
  EXPECT_EQ(size_of("a.svg", "<svg width='20px' height='10.4'/>"), "20 x 10");
  EXPECT_EQ(size_of("a.svg", "<s:svg xmlns:s='x' width='20' height='10'><s:g/>"), "20 x 10");
  EXPECT_EQ(size_of("a.svg", "<?xml version='1.0'?><svg width='100%' viewBox='0,0 40 20'/>"),
            "40 x 20");
  const std::string unknown =
      "is not an SVG that states its size by width and height in pixels or by its viewBox";
  EXPECT_EQ(size_of("a.svg", "<svg/>"), unknown);
  EXPECT_EQ(size_of("a.svg", "<svg viewBox='0 0 -1 nan'/>"), unknown);
  EXPECT_EQ(size_of("a.svg", "<html/>"), unknown);
  EXPECT_EQ(size_of("a.svg", "<svg"), unknown);
}

TEST(ImageSize, OfWhatIsNoPictureIsAnError) {
  EXPECT_EQ(size_of("a.png", ""), "is not a PNG");
  EXPECT_EQ(size_of("a.png", "\x89PNG\r\n\x1a\n"), "is not a PNG");
  EXPECT_EQ(size_of("a.png", encode_png(picture(3, 3)).substr(0, 16)), "is not a PNG");
  EXPECT_EQ(size_of("a.png", encode_webp(picture(3, 3))), "is not a PNG");
  EXPECT_EQ(size_of("a.webp", "RIFF"), "is not a WebP");
  EXPECT_EQ(size_of("a.jpg", "\xff\xd8\xff\xff\xff\xff"), "is not a JPEG");
  EXPECT_EQ(size_of("a.jpg", jpeg(std::string("\xff\xda\x00\x02", 4))), "is not a JPEG");
  EXPECT_EQ(size_of("a.jpg", "\xff\xd8\xff\xe0" + std::string(20, '\0')), "is not a JPEG");
}

}  // namespace
}  // namespace mjcourse
