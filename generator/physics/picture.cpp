#include "physics/picture.h"

#include <png.h>
#include <webp/encode.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace mjcourse {
namespace {

// Of 100. Pictures have two pixels for each of the page's. That hides what 75 costs, and that
// colours are kept at half the resolution (use_sharp_yuv takes as long as all else). At 88 files
// are half as large again.
constexpr float webp_quality = 75;
constexpr unsigned kLongestSideRead = 4096;  // pixels, of a picture that is read

struct FreeWebP {
  void operator()(WebPPicture* picture) const { WebPPictureFree(picture); }
};

// libpng's state, freed at the end.
struct WritePng {
  png_structp png;
  png_infop info;
  ~WritePng() { png_destroy_write_struct(&png, &info); }
};

// Encoders fail only for want of memory or on sizes that no renderer gives.
[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(std::string("cannot encode a picture: ") + what);
}

void require(bool done, const char* what) {
  if (!done) fail(what);
}

[[noreturn]] void throw_png_error(png_structp, png_const_charp message) {
  fail(message);
}

void ignore_png_warning(png_structp, png_const_charp) {}

void append_to_string(png_structp png, png_bytep bytes, std::size_t count) {
  auto* out = static_cast<std::string*>(png_get_io_ptr(png));
  out->append(reinterpret_cast<const char*>(bytes), count);
}

}  // namespace

std::string encode_webp(const Picture& picture) {
  WebPConfig config;
  require(WebPConfigPreset(&config, WEBP_PRESET_DRAWING, webp_quality) != 0, "WebP version");
  config.method = 2;  // 4 takes half as long again for 3 % less

  WebPPicture webp;
  require(WebPPictureInit(&webp) != 0, "WebP version");
  const std::unique_ptr<WebPPicture, FreeWebP> free_picture(&webp);
  WebPMemoryWriter writer;
  WebPMemoryWriterInit(&writer);
  const std::unique_ptr<WebPMemoryWriter, decltype(&WebPMemoryWriterClear)> free_writer(
      &writer, WebPMemoryWriterClear);

  webp.use_argb = 1;
  webp.width = picture.width;
  webp.height = picture.height;
  webp.writer = WebPMemoryWrite;
  webp.custom_ptr = &writer;
  require(WebPPictureImportRGB(&webp, picture.rgb.data(), picture.width * 3) != 0, "WebP import");
  require(WebPEncode(&config, &webp) != 0, "WebP");
  return {reinterpret_cast<const char*>(writer.mem), writer.size};
}

std::string encode_png(const Picture& picture) {
  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, throw_png_error, ignore_png_warning);
  require(png != nullptr, "PNG version");
  const WritePng free_png{png, png_create_info_struct(png)};
  std::string bytes;
  png_set_write_fn(png, &bytes, append_to_string, nullptr);
  png_set_compression_level(png, 6);  // 9 takes four times as long for 3 % less
  // What is drawn comes out a tenth larger with PNG_FILTER_SUB, and two thirds with PNG_FILTER_UP.
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_set_IHDR(png, free_png.info, static_cast<png_uint_32>(picture.width),
               static_cast<png_uint_32>(picture.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, free_png.info);
  for (std::size_t row = 0; row < static_cast<std::size_t>(picture.height); ++row) {
    png_write_row(png, &picture.rgb[row * static_cast<std::size_t>(picture.width) * 3]);
  }
  png_write_end(png, nullptr);
  return bytes;
}

tl::expected<Picture, std::string> decode_png(const std::string& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, decltype(&png_image_free)> free_image(&image, png_image_free);
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) {
    return tl::unexpected(std::string(image.message));
  }
  if (std::max(image.width, image.height) > kLongestSideRead) {
    return tl::unexpected("it is " + std::to_string(image.width) + " × " +
                          std::to_string(image.height) + " pixels large");
  }
  image.format = PNG_FORMAT_RGB;
  Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.rgb.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr) == 0) {
    return tl::unexpected(std::string(image.message));
  }
  return picture;
}

}  // namespace mjcourse
