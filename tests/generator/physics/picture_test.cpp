#include "physics/picture.h"

#include <gtest/gtest.h>
#include <webp/decode.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace mjcourse {
namespace {

// Red above, blue below, brighter to the right.
Picture gradient() {
  Picture picture{48, 32, {}};
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto shade = static_cast<std::uint8_t>(60 + x * 4);
      const bool above = y < picture.height / 2;
      for (const int value : {above ? int{shade} : 0, 0, above ? 0 : int{shade}}) {
        picture.rgb.push_back(static_cast<std::uint8_t>(value));
      }
    }
  }
  return picture;
}

Picture decode_webp(const std::string& bytes) {
  Picture picture;
  std::uint8_t* rgb = WebPDecodeRGB(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                    bytes.size(), &picture.width, &picture.height);
  const std::unique_ptr<std::uint8_t, decltype(&WebPFree)> free_rgb(rgb, WebPFree);
  if (rgb != nullptr) picture.rgb.assign(rgb, rgb + picture.width * picture.height * 3);
  return picture;
}

TEST(Picture, PngKeepsEveryPixel) {
  const Picture picture = gradient();
  const Picture decoded = decode_png(encode_png(picture)).value();
  EXPECT_EQ(decoded.width, 48);
  EXPECT_EQ(decoded.height, 32);
  EXPECT_EQ(decoded.rgb, picture.rgb);
}

TEST(Picture, WebpKeepsSizeAndLook) {
  const Picture picture = gradient();
  const Picture decoded = decode_webp(encode_webp(picture));
  ASSERT_EQ(decoded.width, 48);
  ASSERT_EQ(decoded.height, 32);
  ASSERT_EQ(decoded.rgb.size(), picture.rgb.size());
  long difference = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    difference += std::abs(int{picture.rgb[i]} - int{decoded.rgb[i]});
  }
  EXPECT_LT(difference / static_cast<long>(picture.rgb.size()), 6);
}

TEST(Picture, EncodesToTheSameBytesEachTime) {
  EXPECT_EQ(encode_png(gradient()), encode_png(gradient()));
  EXPECT_EQ(encode_webp(gradient()), encode_webp(gradient()));
}

TEST(Picture, IsReadFromPngOnlyWhereThatIsSound) {
  const std::string bytes = encode_png(gradient());
  EXPECT_EQ(decode_png("").error(), "png_image_begin_read_from_memory: invalid argument");
  EXPECT_EQ(decode_png("GIF89a" + bytes).error(), "Not a PNG file");
  EXPECT_FALSE(decode_png(bytes.substr(0, bytes.size() / 2)));
  std::string broken = bytes;
  broken[60] ^= 1;
  EXPECT_FALSE(decode_png(broken));
  EXPECT_EQ(decode_png(encode_png({5000, 1, std::vector<std::uint8_t>(15000)})).error(),
            "it is 5000 × 1 pixels large");
}

}  // namespace
}  // namespace mjcourse
